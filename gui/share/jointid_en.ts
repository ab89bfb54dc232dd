<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="en" sourcelanguage="en">
<context>
    <name>ComparePage</name>
    <message numerus="yes">
        <source>Cancelled; %n way(s) that were done are shown.</source>
        <translation>
            <numerusform>Cancelled; %n way that was done are shown.</numerusform>
            <numerusform>Cancelled; %n ways that were done are shown.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n way(s) on the same trials.</source>
        <translation>
            <numerusform>%n way on the same trials.</numerusform>
            <numerusform>%n ways on the same trials.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>FrfTab</name>
    <message numerus="yes">
        <source>; %n outlier line(s), red below the curves</source>
        <translation>
            <numerusform>; %n outlier line, red below the curves</numerusform>
            <numerusform>; %n outlier lines, red below the curves</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>MainWindow</name>
    <message numerus="yes">
        <source>Looking at %n file(s) …</source>
        <translation>
            <numerusform>Looking at %n file …</numerusform>
            <numerusform>Looking at %n files …</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ModalPage</name>
    <message numerus="yes">
        <source>%n mode(s); %1</source>
        <translation>
            <numerusform>%n mode; %1</numerusform>
            <numerusform>%n modes; %1</numerusform>
        </translation>
    </message>
</context>
</TS>
