<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="en" sourcelanguage="en">
<context>
    <name>ComparePage</name>
    <message numerus="yes">
        <source>Cancelled: %n finished way(s).</source>
        <translation>
            <numerusform>Cancelled: %n finished way.</numerusform>
            <numerusform>Cancelled: %n finished ways.</numerusform>
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
    <name>DifferenceTab</name>
    <message numerus="yes">
        <source>%n unknown(s) differ beyond the intervals of both. ± is 95 %.</source>
        <translation>
            <numerusform>%n unknown differs beyond the intervals of both. ± is 95 %.</numerusform>
            <numerusform>%n unknowns differ beyond the intervals of both. ± is 95 %.</numerusform>
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
    <name>JointAssistant</name>
    <message numerus="yes">
        <source>%1: %n unknown(s)</source>
        <translation>
            <numerusform>%1: %n unknown</numerusform>
            <numerusform>%1: %n unknowns</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>MainWindow</name>
    <message numerus="yes">
        <source>Reading %n file(s) …</source>
        <translation>
            <numerusform>Reading %n file …</numerusform>
            <numerusform>Reading %n files …</numerusform>
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
