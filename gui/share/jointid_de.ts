<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de" sourcelanguage="en">
<context>
    <name>CellTable</name>
    <message>
        <source>&amp;Copy</source>
        <translation>&amp;Kopieren</translation>
    </message>
    <message>
        <source>&amp;Save as CSV…</source>
        <translation>Als CSV &amp;speichern …</translation>
    </message>
    <message>
        <source>Save the table</source>
        <translation>Die Tabelle speichern</translation>
    </message>
    <message>
        <source>Tables (*.csv)</source>
        <translation>Tabellen (*.csv)</translation>
    </message>
    <message>
        <source>Not saved</source>
        <translation>Nicht gespeichert</translation>
    </message>
</context>
<context>
    <name>Chart</name>
    <message>
        <source>The chosen point</source>
        <translation>Der gewählte Punkt</translation>
    </message>
    <message>
        <source>Copy the numbers for a spreadsheet, and the picture</source>
        <translation>Die Zahlen für eine Tabellenkalkulation kopieren, und das Bild</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>Kopieren</translation>
    </message>
    <message>
        <source>Save as PNG, SVG, PDF or CSV</source>
        <translation>Als PNG, SVG, PDF oder CSV speichern</translation>
    </message>
    <message>
        <source>Save…</source>
        <translation>Speichern …</translation>
    </message>
</context>
<context>
    <name>ChoiceButton</name>
    <message>
        <source>Choices to compare. None: as in the scene</source>
        <translation>Zu vergleichende Möglichkeiten. Keine: wie in der Szene</translation>
    </message>
    <message>
        <source>as in the scene</source>
        <translation>wie in der Szene</translation>
    </message>
</context>
<context>
    <name>ChoiceRow</name>
    <message>
        <source>Add</source>
        <translation>Hinzufügen</translation>
    </message>
    <message>
        <source>Add another one to the text</source>
        <translation>Fügt dem Text ein weiteres hinzu</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Entfernen</translation>
    </message>
    <message>
        <source>Remove this one from the text; undo brings it back</source>
        <translation>Entfernt dieses aus dem Text; Rückgängig bringt es zurück</translation>
    </message>
</context>
<context>
    <name>CompareChoices</name>
    <message>
        <source>Choices to compare</source>
        <translation>Was verglichen wird</translation>
    </message>
    <message>
        <source>method</source>
        <translation>Methode</translation>
    </message>
    <message>
        <source>equations</source>
        <translation>Gleichungen</translation>
    </message>
    <message>
        <source>weighting</source>
        <translation>Gewichtung</translation>
    </message>
    <message>
        <source>Δ</source>
        <translation>Δ</translation>
    </message>
    <message>
        <source>solver</source>
        <translation>Löser</translation>
    </message>
    <message>
        <source>by modes</source>
        <translation>aus Moden</translation>
    </message>
</context>
<context>
    <name>ComparePage</name>
    <message>
        <source>Compare</source>
        <translation>Vergleich</translation>
    </message>
    <message>
        <source>Status of the comparison</source>
        <translation>Status des Vergleichs</translation>
    </message>
    <message>
        <source>Error against run time</source>
        <translation>Fehler über Rechenzeit</translation>
    </message>
    <message>
        <source>Choose what to compare, then press Compare. The diagram shows the error and the run time of every way.
The scene needs [truth] and [noise]. A click on a point opens that solution.</source>
        <translation>Wählen Sie, was verglichen wird, dann „Vergleich“. Das Diagramm zeigt Fehler und Rechenzeit jedes Wegs.
Die Szene braucht [truth] und [noise]. Ein Klick auf einen Punkt öffnet diese Lösung.</translation>
    </message>
    <message>
        <source>Ways, by their error and run time</source>
        <translation>Wege, nach Fehler und Rechenzeit</translation>
    </message>
    <message>
        <source>Diagram and table</source>
        <translation>Diagramm und Tabelle</translation>
    </message>
    <message>
        <source>Cancelled: no way was finished.</source>
        <translation>Abgebrochen: kein Weg war fertig.</translation>
    </message>
    <message>
        <source>Comparing</source>
        <translation>Vergleichen</translation>
    </message>
    <message>
        <source>Compare all ways on the same trials with simulated noise</source>
        <translation>Alle Wege an denselben Versuchen mit simuliertem Rauschen vergleichen</translation>
    </message>
    <message>
        <source>Stop and keep the finished ways</source>
        <translation>Anhalten und die fertigen Wege behalten</translation>
    </message>
    <message>
        <source>trials</source>
        <translation>Versuche</translation>
    </message>
    <message>
        <source>seed</source>
        <translation>Startzahl</translation>
    </message>
    <message>
        <source>Matrix whose error is shown</source>
        <translation>Matrix, deren Fehler gezeigt wird</translation>
    </message>
    <message>
        <source>Copy as command</source>
        <translation>Als Befehl kopieren</translation>
    </message>
    <message>
        <source>Copy the command line that compares the same ways on the same trials</source>
        <translation>Die Befehlszeile kopieren, die dieselben Wege an denselben Versuchen vergleicht</translation>
    </message>
    <message>
        <source>Comparing …</source>
        <translation>Wird verglichen …</translation>
    </message>
    <message numerus="yes">
        <source>Cancelled: %n finished way(s).</source>
        <translation>
            <numerusform>Abgebrochen: ein fertiger Weg.</numerusform>
            <numerusform>Abgebrochen: %n fertige Wege.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n way(s) on the same trials.</source>
        <translation>
            <numerusform>Ein Weg an denselben Versuchen.</numerusform>
            <numerusform>%n Wege an denselben Versuchen.</numerusform>
        </translation>
    </message>
    <message>
        <source>left out: </source>
        <translation>ausgelassen: </translation>
    </message>
    <message>
        <source>SCENE.toml</source>
        <translation>SZENE.toml</translation>
    </message>
</context>
<context>
    <name>CouplePage</name>
    <message>
        <source>Coupling</source>
        <translation>Kopplung</translation>
    </message>
    <message>
        <source>Status of the coupling</source>
        <translation>Status der Kopplung</translation>
    </message>
    <message>
        <source>Stop without writing a file</source>
        <translation>Anhalten, ohne eine Datei zu schreiben</translation>
    </message>
    <message>
        <source>Predicted and measured FRFs</source>
        <translation>Vorhergesagte und gemessene FRFs</translation>
    </message>
    <message>
        <source>This page shows the FRFs of the assembly, predicted from its substructures and joints.
It needs a scene with [data] parts and [couple]. Measured FRFs can be drawn over them.</source>
        <translation>Diese Seite zeigt die FRFs des Zusammenbaus, vorhergesagt aus Substrukturen und Fügestellen.
Sie braucht eine Szene mit [data] parts und [couple]. Gemessene FRFs lassen sich darüber zeichnen.</translation>
    </message>
    <message>
        <source>Diagram and tables</source>
        <translation>Diagramm und Tabellen</translation>
    </message>
    <message>
        <source>Couple</source>
        <translation>Koppeln</translation>
    </message>
    <message>
        <source>Predict the FRFs of the assembly and write them beside the scene</source>
        <translation>Die FRFs des Zusammenbaus vorhersagen und neben die Szene schreiben</translation>
    </message>
    <message>
        <source>bounds</source>
        <translation>Schranken</translation>
    </message>
    <message>
        <source>Bounds</source>
        <translation>Schranken</translation>
    </message>
    <message>
        <source>Compute without redundant compatibility conditions, and with all of them: the true FRF lies between</source>
        <translation>Ohne redundante Kompatibilitätsbedingungen rechnen, und mit allen: die wahre FRF liegt dazwischen</translation>
    </message>
    <message>
        <source>Measured…</source>
        <translation>Gemessen …</translation>
    </message>
    <message>
        <source>Choose measured FRFs of the assembly for comparison</source>
        <translation>Gemessene FRFs des Zusammenbaus zum Vergleich wählen</translation>
    </message>
    <message>
        <source>Measured files</source>
        <translation>Gemessene Dateien</translation>
    </message>
    <message>
        <source>Copy as command</source>
        <translation>Als Befehl kopieren</translation>
    </message>
    <message>
        <source>Copy the command line that writes the same file</source>
        <translation>Die Befehlszeile kopieren, die dieselbe Datei schreibt</translation>
    </message>
    <message>
        <source>Resonances of the assembly</source>
        <translation>Resonanzen des Zusammenbaus</translation>
    </message>
    <message>
        <source>Errors of the predicted FRFs, largest first</source>
        <translation>Fehler der vorhergesagten FRFs, der größte zuerst</translation>
    </message>
    <message>
        <source>Compatibility conditions, used and left out</source>
        <translation>Kompatibilitätsbedingungen, verwendete und ausgelassene</translation>
    </message>
    <message>
        <source>Resonances, errors and compatibility</source>
        <translation>Resonanzen, Fehler und Kompatibilität</translation>
    </message>
    <message>
        <source>Resonances</source>
        <translation>Resonanzen</translation>
    </message>
    <message>
        <source>Errors</source>
        <translation>Fehler</translation>
    </message>
    <message>
        <source>Compatibility</source>
        <translation>Kompatibilität</translation>
    </message>
    <message>
        <source>Save the scene first. The FRFs of the assembly are written beside it.</source>
        <translation>Speichern Sie zuerst die Szene. Die FRFs des Zusammenbaus werden daneben geschrieben.</translation>
    </message>
    <message>
        <source>Coupling …</source>
        <translation>Wird gekoppelt …</translation>
    </message>
    <message>
        <source>written to %1</source>
        <translation>geschrieben nach %1</translation>
    </message>
    <message>
        <source>condition number of S</source>
        <translation>Konditionszahl von S</translation>
    </message>
    <message>
        <source>alpha</source>
        <translation>Alpha</translation>
    </message>
    <message>
        <source>SCENE.toml</source>
        <translation>SZENE.toml</translation>
    </message>
</context>
<context>
    <name>DataPage</name>
    <message>
        <source>Data</source>
        <translation>Daten</translation>
    </message>
    <message>
        <source>Choose FRFs in the grid: click, drag, Ctrl+click, or whole rows and columns by their names.</source>
        <translation>Wählen Sie FRFs im Raster: Klicken, Ziehen, Strg+Klick, oder ganze Zeilen und Spalten an ihren Namen.</translation>
    </message>
    <message>
        <source>Files</source>
        <translation>Dateien</translation>
    </message>
    <message>
        <source>Files of the scene</source>
        <translation>Dateien der Szene</translation>
    </message>
    <message>
        <source>About the file</source>
        <translation>Über die Datei</translation>
    </message>
    <message>
        <source>Colour by</source>
        <translation>Farbe nach</translation>
    </message>
    <message>
        <source>Quantity that colours the cells</source>
        <translation>Größe, die die Zellen färbt</translation>
    </message>
    <message>
        <source>in all files</source>
        <translation>in allen Dateien</translation>
    </message>
    <message>
        <source>Draw the chosen FRFs of all files that have them</source>
        <translation>Die gewählten FRFs aller Dateien zeichnen, die sie haben</translation>
    </message>
    <message>
        <source>Draw the chosen FRFs of all files that have them, one over the other</source>
        <translation>Die gewählten FRFs aller Dateien, die sie haben, übereinander zeichnen</translation>
    </message>
    <message>
        <source>Rows are the joint</source>
        <translation>Zeilen sind die Fügestelle</translation>
    </message>
    <message>
        <source>Take the chosen rows as joint DOFs</source>
        <translation>Die gewählten Zeilen als DOFs der Fügestelle nehmen</translation>
    </message>
    <message>
        <source>Write the DOFs of the chosen rows into [joint] dofs</source>
        <translation>Die DOFs der gewählten Zeilen in [joint] dofs schreiben</translation>
    </message>
    <message>
        <source>FRFs of the file: responses down, references across</source>
        <translation>FRFs der Datei: Antworten nach unten, Referenzen nach rechts</translation>
    </message>
    <message>
        <source>Files and grid</source>
        <translation>Dateien und Raster</translation>
    </message>
    <message>
        <source>Files and plot</source>
        <translation>Dateien und Diagramm</translation>
    </message>
    <message>
        <source>substructures</source>
        <translation>Substrukturen</translation>
    </message>
    <message>
        <source>assembly</source>
        <translation>Zusammenbau</translation>
    </message>
</context>
<context>
    <name>DifferenceTab</name>
    <message>
        <source>The other run</source>
        <translation>Der andere Lauf</translation>
    </message>
    <message>
        <source>Runs of this scene, and of the other scenes that are open</source>
        <translation>Läufe dieser Szene und der anderen offenen Szenen</translation>
    </message>
    <message>
        <source>About the differences</source>
        <translation>Zu den Unterschieden</translation>
    </message>
    <message>
        <source>Differences of the unknowns</source>
        <translation>Unterschiede der Unbekannten</translation>
    </message>
    <message>
        <source>run %1</source>
        <translation>Lauf %1</translation>
    </message>
    <message>
        <source>Two runs are compared here: solve this scene twice, or solve another scene that is open, of another tightening.</source>
        <translation>Hier werden zwei Läufe verglichen: Lösen Sie diese Szene zweimal, oder eine andere offene Szene, etwa nach neuem Anziehen.</translation>
    </message>
    <message>
        <source>The two runs have no unknown in common.</source>
        <translation>Die beiden Läufe haben keine gemeinsame Unbekannte.</translation>
    </message>
    <message numerus="yes">
        <source>%n unknown(s) differ beyond the intervals of both. ± is 95 %.</source>
        <translation>
            <numerusform>%n Unbekannte unterscheidet sich über die Intervalle beider hinaus. ± ist 95 %.</numerusform>
            <numerusform>%n Unbekannte unterscheiden sich über die Intervalle beider hinaus. ± ist 95 %.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ExampleDialog</name>
    <message>
        <source>Open example</source>
        <translation>Beispiel öffnen</translation>
    </message>
    <message>
        <source>Words that the example has</source>
        <translation>Wörter des Beispiels</translation>
    </message>
    <message>
        <source>Search: bolt, rubber, friction …</source>
        <translation>Suche: bolt, rubber, friction …</translation>
    </message>
    <message>
        <source>Examples with known answers</source>
        <translation>Beispiele mit bekannter Lösung</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>What it is</source>
        <translation>Worum es geht</translation>
    </message>
    <message>
        <source>Open the example, or leave it</source>
        <translation>Das Beispiel öffnen oder nicht</translation>
    </message>
    <message>
        <source>Folder of the examples</source>
        <translation>Ordner der Beispiele</translation>
    </message>
    <message>
        <source>The files go into a folder of their own below this one</source>
        <translation>Die Dateien kommen in einen eigenen Ordner darunter</translation>
    </message>
    <message>
        <source>Folder…</source>
        <translation>Ordner…</translation>
    </message>
    <message>
        <source>Choose the folder of the examples</source>
        <translation>Den Ordner der Beispiele wählen</translation>
    </message>
    <message>
        <source>Files to</source>
        <translation>Dateien nach</translation>
    </message>
</context>
<context>
    <name>Field</name>
    <message>
        <source>Error in %1</source>
        <translation>Fehler in %1</translation>
    </message>
    <message>
        <source>Names to choose from</source>
        <translation>Namen zur Auswahl</translation>
    </message>
    <message>
        <source>default</source>
        <translation>Vorgabe</translation>
    </message>
    <message>
        <source>Choose files of %1</source>
        <translation>Dateien für %1 wählen</translation>
    </message>
    <message>
        <source>Choose files to add</source>
        <translation>Dateien zum Hinzufügen wählen</translation>
    </message>
    <message>
        <source>This value contains comments. Edit it in the text.</source>
        <translation>Dieser Wert enthält Kommentare. Ändern Sie ihn im Text.</translation>
    </message>
</context>
<context>
    <name>FindingsPage</name>
    <message>
        <source>Stop without showing results</source>
        <translation>Anhalten, ohne Ergebnisse zu zeigen</translation>
    </message>
    <message>
        <source>Copy as command</source>
        <translation>Als Befehl kopieren</translation>
    </message>
    <message>
        <source>Copy the command line with the same results</source>
        <translation>Die Befehlszeile mit denselben Ergebnissen kopieren</translation>
    </message>
    <message>
        <source>Diagram and tables</source>
        <translation>Diagramm und Tabellen</translation>
    </message>
    <message>
        <source>Computing …</source>
        <translation>Rechnet …</translation>
    </message>
</context>
<context>
    <name>FrfGridModel</name>
    <message>
        <source>missing</source>
        <translation>fehlt</translation>
    </message>
    <message>
        <source>response %1, reference %2: %3</source>
        <translation>Antwort %1, Referenz %2: %3</translation>
    </message>
    <message>
        <source>joint DOF</source>
        <translation>DOF der Fügestelle</translation>
    </message>
</context>
<context>
    <name>FrfPlot</name>
    <message>
        <source>magnitude and phase</source>
        <translation>Betrag und Phase</translation>
    </message>
    <message>
        <source>real and imaginary part</source>
        <translation>Real- und Imaginärteil</translation>
    </message>
    <message>
        <source>Nyquist</source>
        <translation>Nyquist</translation>
    </message>
    <message>
        <source>coherence</source>
        <translation>Kohärenz</translation>
    </message>
    <message>
        <source>computed over measured</source>
        <translation>berechnet zu gemessen</translation>
    </message>
    <message>
        <source>sum of magnitudes</source>
        <translation>Summe der Beträge</translation>
    </message>
    <message>
        <source>CMIF</source>
        <translation>CMIF</translation>
    </message>
    <message>
        <source>FRFs</source>
        <translation>FRFs</translation>
    </message>
    <message>
        <source>Values at the cursor</source>
        <translation>Werte am Zeiger</translation>
    </message>
    <message>
        <source>What is drawn</source>
        <translation>Was gezeichnet wird</translation>
    </message>
    <message>
        <source>Quantity</source>
        <translation>Größe</translation>
    </message>
    <message>
        <source>Exclude</source>
        <translation>Auslassen</translation>
    </message>
    <message>
        <source>All</source>
        <translation>Alles</translation>
    </message>
    <message>
        <source>Show all frequencies (Home, or a double click)</source>
        <translation>Alle Frequenzen zeigen (Pos1 oder Doppelklick)</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>Kopieren</translation>
    </message>
    <message>
        <source>Copy the curves for a spreadsheet, and the picture</source>
        <translation>Die Kurven für eine Tabellenkalkulation kopieren, und das Bild</translation>
    </message>
    <message>
        <source>Save…</source>
        <translation>Speichern …</translation>
    </message>
    <message>
        <source>Save as PNG, SVG, PDF or CSV</source>
        <translation>Als PNG, SVG, PDF oder CSV speichern</translation>
    </message>
    <message>
        <source>While pressed, drag to leave a band out of the identification. Delete takes the band at the cursor in again</source>
        <translation>Gedrückt: Ziehen lässt ein Band bei der Identifikation weg. Entf nimmt das Band am Cursor wieder auf</translation>
    </message>
    <message>
        <source>dB</source>
        <translation>dB</translation>
    </message>
    <message>
        <source>Magnitudes in decibel</source>
        <translation>Beträge in Dezibel</translation>
    </message>
    <message>
        <source>Peaks</source>
        <translation>Spitzen</translation>
    </message>
    <message>
        <source>Peaks of the first curve; a choice moves the cursor there</source>
        <translation>Spitzen der ersten Kurve; eine Auswahl setzt den Cursor dorthin</translation>
    </message>
    <message>
        <source>Window</source>
        <translation>Fenster</translation>
    </message>
    <message>
        <source>Show the curves in a window of their own</source>
        <translation>Die Kurven in einem eigenen Fenster zeigen</translation>
    </message>
    <message>
        <source>%1 Hz: %2 %3</source>
        <translation>%1 Hz: %2 %3</translation>
    </message>
    <message>
        <source>no peak</source>
        <translation>keine Spitze</translation>
    </message>
</context>
<context>
    <name>FrfTab</name>
    <message>
        <source>Response</source>
        <translation>Antwort</translation>
    </message>
    <message>
        <source>Reference</source>
        <translation>Referenz</translation>
    </message>
    <message>
        <source>all runs</source>
        <translation>alle Läufe</translation>
    </message>
    <message>
        <source>Draw the synthesised FRFs of all runs</source>
        <translation>Die synthetisierten FRFs aller Läufe zeichnen</translation>
    </message>
    <message>
        <source>Draw the FRFs synthesised with the joint of every run of the session</source>
        <translation>Die mit der Fügestelle jedes Laufs der Sitzung synthetisierten FRFs zeichnen</translation>
    </message>
    <message>
        <source>Error of the synthesised FRF</source>
        <translation>Fehler der synthetisierten FRF</translation>
    </message>
    <message>
        <source>After solving, this tab shows the FRFs of the assembly, measured and synthesised with the joint.</source>
        <translation>Nach dem Lösen zeigt dieser Reiter die FRFs des Zusammenbaus, gemessen und mit der Fügestelle synthetisiert.</translation>
    </message>
    <message>
        <source>error %1 dB (rms)</source>
        <translation>Fehler %1 dB (Effektivwert)</translation>
    </message>
    <message>
        <source>not comparable</source>
        <translation>nicht vergleichbar</translation>
    </message>
    <message numerus="yes">
        <source>; %n outlier line(s), red below the curves</source>
        <translation>
            <numerusform>; eine Ausreißer-Linie, rot unter den Kurven</numerusform>
            <numerusform>; %n Ausreißer-Linien, rot unter den Kurven</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>GeometryPage</name>
    <message>
        <source>Geometry</source>
        <translation>Geometrie</translation>
    </message>
    <message>
        <source>Measured DOFs. Ticked: joint DOFs</source>
        <translation>Gemessene DOFs. Angekreuzt: DOFs der Fügestelle</translation>
    </message>
    <message>
        <source>Space adds a DOF to [joint] dofs, or removes it</source>
        <translation>Leertaste nimmt ein DOF in [joint] dofs auf oder heraus</translation>
    </message>
    <message>
        <source>About the structure</source>
        <translation>Über die Struktur</translation>
    </message>
    <message>
        <source>DOFs and structure</source>
        <translation>DOFs und Struktur</translation>
    </message>
    <message>
        <source>%1 nodes, %2 lines, %3 DOFs. Click an arrow, or tick a DOF, to add it to the joint or remove it.</source>
        <translation>%1 Knoten, %2 Linien, %3 DOFs. Klicken Sie einen Pfeil an, oder kreuzen Sie ein DOF an, um es der Fügestelle zuzuordnen oder herauszunehmen.</translation>
    </message>
    <message>
        <source>The assembly under a force at %1, at its line %2 Hz.</source>
        <translation>Der Zusammenbau unter einer Kraft an %1, an seiner Linie %2 Hz.</translation>
    </message>
    <message>
        <source>Mode %1.</source>
        <translation>Mode %1.</translation>
    </message>
    <message>
        <source>
Joint: %1</source>
        <translation>
Fügestelle: %1</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>Kopieren</translation>
    </message>
    <message>
        <source>Copy the nodes for a spreadsheet, and the picture</source>
        <translation>Die Knoten für eine Tabellenkalkulation kopieren, und das Bild</translation>
    </message>
    <message>
        <source>Save…</source>
        <translation>Speichern …</translation>
    </message>
    <message>
        <source>Front</source>
        <translation>Vorn</translation>
    </message>
    <message>
        <source>Look along y: x to the right, z up (F)</source>
        <translation>Blick entlang y: x nach rechts, z nach oben (F)</translation>
    </message>
    <message>
        <source>Side</source>
        <translation>Seite</translation>
    </message>
    <message>
        <source>Look along x: y to the right, z up (S)</source>
        <translation>Blick entlang x: y nach rechts, z nach oben (S)</translation>
    </message>
    <message>
        <source>Top</source>
        <translation>Oben</translation>
    </message>
    <message>
        <source>Look down: x to the right, y up (T)</source>
        <translation>Blick nach unten: x nach rechts, y nach oben (T)</translation>
    </message>
    <message>
        <source>Save as PNG, SVG, PDF or CSV; a motion as a film (GIF), too</source>
        <translation>Als PNG, SVG, PDF oder CSV speichern; eine Bewegung auch als Film (GIF)</translation>
    </message>
    <message>
        <source>Lines</source>
        <translation>Linien</translation>
    </message>
    <message>
        <source>Draw lines between nodes, or remove them (L)</source>
        <translation>Linien zwischen Knoten zeichnen oder entfernen (L)</translation>
    </message>
</context>
<context>
    <name>HeatChart</name>
    <message>
        <source>The value under the mouse</source>
        <translation>Der Wert unter der Maus</translation>
    </message>
    <message>
        <source>log10 of %1</source>
        <translation>log10 von %1</translation>
    </message>
</context>
<context>
    <name>HelpWindow</name>
    <message>
        <source>Documentation</source>
        <translation>Dokumentation</translation>
    </message>
    <message>
        <source>Page of the documentation</source>
        <translation>Seite der Dokumentation</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Zurück</translation>
    </message>
    <message>
        <source>To the page before (Alt+Left)</source>
        <translation>Zur Seite davor (Alt+Links)</translation>
    </message>
</context>
<context>
    <name>JobLine</name>
    <message>
        <source>Cancelled.</source>
        <translation>Abgebrochen.</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
</context>
<context>
    <name>JobProgress</name>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>%1 min</source>
        <translation>%1 min</translation>
    </message>
    <message>
        <source>%1 h</source>
        <translation>%1 h</translation>
    </message>
    <message>
        <source>Progress</source>
        <translation>Fortschritt</translation>
    </message>
    <message>
        <source>, %1 left</source>
        <translation>, noch %1</translation>
    </message>
    <message>
        <source>%1 min %2 s</source>
        <translation>%1 min %2 s</translation>
    </message>
    <message>
        <source>%1 of %2: </source>
        <translation>%1 von %2: </translation>
    </message>
</context>
<context>
    <name>JointAssistant</name>
    <message>
        <source>Joint assistant</source>
        <translation>Fügestellen-Assistent</translation>
    </message>
    <message>
        <source>Pairs of nodes. Ticked: joined</source>
        <translation>Knotenpaare. Angekreuzt: verbunden</translation>
    </message>
    <message>
        <source>Space joins the nodes of a pair, or parts them</source>
        <translation>Leertaste verbindet die Knoten eines Paars oder trennt sie</translation>
    </message>
    <message>
        <source>Nodes</source>
        <translation>Knoten</translation>
    </message>
    <message>
        <source>Gap in mm</source>
        <translation>Abstand in mm</translation>
    </message>
    <message>
        <source>Directions</source>
        <translation>Richtungen</translation>
    </message>
    <message>
        <source>Tick the pairs of nodes that a bolt, a weld or a pad joins.</source>
        <translation>Kreuzen Sie die Knotenpaare an, die eine Schraube, eine Schweißnaht oder ein Lager verbindet.</translation>
    </message>
    <message>
        <source>What to do</source>
        <translation>Was zu tun ist</translation>
    </message>
    <message>
        <source>About the number of unknowns</source>
        <translation>Zur Zahl der Unbekannten</translation>
    </message>
    <message>
        <source>Write the joint, or leave it</source>
        <translation>Fügestelle schreiben oder es lassen</translation>
    </message>
    <message>
        <source>No two nodes of different parts lie near each other. Add the pairs that are joined.</source>
        <translation>Keine zwei Knoten verschiedener Substrukturen liegen nahe beieinander. Fügen Sie die verbundenen Paare hinzu.</translation>
    </message>
    <message>
        <source>Node of one part</source>
        <translation>Knoten der einen Substruktur</translation>
    </message>
    <message>
        <source>Node of another part</source>
        <translation>Knoten einer anderen Substruktur</translation>
    </message>
    <message>
        <source>Add pair</source>
        <translation>Paar hinzufügen</translation>
    </message>
    <message>
        <source>Add the two nodes to the pairs</source>
        <translation>Die zwei Knoten zu den Paaren hinzufügen</translation>
    </message>
    <message>
        <source>Directions:</source>
        <translation>Richtungen:</translation>
    </message>
    <message>
        <source>Joined along %1</source>
        <translation>Verbunden längs %1</translation>
    </message>
    <message>
        <source>A spring for every pair and direction</source>
        <translation>Eine Feder je Paar und Richtung</translation>
    </message>
    <message>
        <source>Equal bolts: a spring for every direction</source>
        <translation>Gleiche Schrauben: eine Feder je Richtung</translation>
    </message>
    <message>
        <source>Full symmetric matrices</source>
        <translation>Volle symmetrische Matrizen</translation>
    </message>
    <message>
        <source>with hysteretic damping</source>
        <translation>mit hysteretischer Dämpfung</translation>
    </message>
    <message>
        <source>Hysteretic damping beside every stiffness</source>
        <translation>Hysteretische Dämpfung neben jeder Steifigkeit</translation>
    </message>
    <message>
        <source>Both nodes are of one part: take nodes of two parts.</source>
        <translation>Beide Knoten gehören zu einer Substruktur: Nehmen Sie Knoten zweier Substrukturen.</translation>
    </message>
    <message>
        <source>The two nodes share no direction that is response and reference.</source>
        <translation>Die zwei Knoten haben keine gemeinsame Richtung, die Antwort und Anregung ist.</translation>
    </message>
    <message>
        <source>The pair is in the list.</source>
        <translation>Das Paar steht in der Liste.</translation>
    </message>
    <message numerus="yes">
        <source>%1: %n unknown(s)</source>
        <translation>
            <numerusform>%1: %n Unbekannte</numerusform>
            <numerusform>%1: %n Unbekannte</numerusform>
        </translation>
    </message>
    <message>
        <source>Few tests determine more than %1 unknowns, and solving takes long.</source>
        <translation>Wenige Versuche bestimmen mehr als %1 Unbekannte, und das Lösen dauert lange.</translation>
    </message>
    <message>
        <source>without limit</source>
        <translation>unbegrenzt</translation>
    </message>
    <message>
        <source>Expected time and intervals</source>
        <translation>Erwartete Zeit und Intervalle</translation>
    </message>
    <message>
        <source>No forecast: %1</source>
        <translation>Keine Vorhersage: %1</translation>
    </message>
    <message>
        <source>Rigid plates: six springs between two virtual points</source>
        <translation>Starre Platten: sechs Federn zwischen zwei virtuellen Punkten</translation>
    </message>
    <message>
        <source>Forecasting time and intervals …</source>
        <translation>Zeit und Intervalle werden vorhergesagt …</translation>
    </message>
    <message>
        <source>Less than a second</source>
        <translation>Weniger als eine Sekunde</translation>
    </message>
    <message>
        <source>About %1</source>
        <translation>Etwa %1</translation>
    </message>
    <message>
        <source>%1. No intervals: %2.</source>
        <translation>%1. Keine Intervalle: %2.</translation>
    </message>
    <message>
        <source>%1. 95 % intervals, about: ± %2 in the middle, ± %3 of the worst unknown.</source>
        <translation>%1. 95-%-Intervalle, etwa: ± %2 in der Mitte, ± %3 der schlechtesten Unbekannten.</translation>
    </message>
</context>
<context>
    <name>JointTab</name>
    <message>
        <source>Matrix and band</source>
        <translation>Matrix und Band</translation>
    </message>
    <message>
        <source>Joint matrix</source>
        <translation>Matrix der Fügestelle</translation>
    </message>
    <message>
        <source> (SI)</source>
        <translation> (SI)</translation>
    </message>
    <message>
        <source>, %1 to %2 Hz</source>
        <translation>, %1 bis %2 Hz</translation>
    </message>
    <message>
        <source>± is 95 %, of linear methods their error. Blue is positive, orange negative, blank is zero and no unknown.</source>
        <translation>± ist 95 %, bei linearen Verfahren ihr Fehler. Blau ist positiv, orange negativ, leer ist null und keine Unbekannte.</translation>
    </message>
    <message>
        <source>How to read the matrix</source>
        <translation>Wie die Matrix zu lesen ist</translation>
    </message>
</context>
<context>
    <name>LoadingCurveChoices</name>
    <message>
        <source>Columns and laws</source>
        <translation>Spalten und Gesetze</translation>
    </message>
    <message>
        <source>displacement</source>
        <translation>Weg</translation>
    </message>
    <message>
        <source>Column of displacements, angles or amplitudes</source>
        <translation>Spalte der Wege, Winkel oder Amplituden</translation>
    </message>
    <message>
        <source>force</source>
        <translation>Kraft</translation>
    </message>
    <message>
        <source>Column of forces or torques</source>
        <translation>Spalte der Kräfte oder Momente</translation>
    </message>
    <message>
        <source>energy</source>
        <translation>Energie</translation>
    </message>
    <message>
        <source>Instead of forces: energies per cycle over amplitude</source>
        <translation>Statt der Kräfte: Energien je Zyklus über der Amplitude</translation>
    </message>
    <message>
        <source>k_e</source>
        <translation>k_e</translation>
    </message>
    <message>
        <source>Instead of forces: equivalent stiffnesses over amplitude …</source>
        <translation>Statt der Kräfte: äquivalente Steifigkeiten über der Amplitude …</translation>
    </message>
    <message>
        <source>d_e</source>
        <translation>d_e</translation>
    </message>
    <message>
        <source>… and equivalent dampings</source>
        <translation>… und äquivalente Dämpfungen</translation>
    </message>
    <message>
        <source>Unit of displacements. Empty: that of the header, else m</source>
        <translation>Einheit der Wege. Leer: die des Kopfs, sonst m</translation>
    </message>
    <message>
        <source>Unit of forces. Empty: that of the header, else N</source>
        <translation>Einheit der Kräfte. Leer: die des Kopfs, sonst N</translation>
    </message>
    <message>
        <source>Loaded once from rest, or cycles</source>
        <translation>Einmal aus der Ruhe belastet, oder Zyklen</translation>
    </message>
    <message>
        <source>Weighting of the residuals</source>
        <translation>Gewichtung der Residuen</translation>
    </message>
    <message>
        <source>laws</source>
        <translation>Gesetze</translation>
    </message>
    <message>
        <source>all</source>
        <translation>alle</translation>
    </message>
    <message>
        <source>Laws to fit; nothing chosen: all</source>
        <translation>Anzupassende Gesetze; nichts gewählt: alle</translation>
    </message>
    <message>
        <source>Given friction limit</source>
        <translation>Vorgegebene Reibgrenze</translation>
    </message>
    <message>
        <source>Given friction limit. 0: unknown</source>
        <translation>Vorgegebene Reibgrenze. 0: unbekannt</translation>
    </message>
    <message>
        <source>limit </source>
        <translation>Grenze </translation>
    </message>
    <message>
        <source>limit: unknown</source>
        <translation>Grenze: unbekannt</translation>
    </message>
</context>
<context>
    <name>LoadingCurvePage</name>
    <message>
        <source>Best law by AIC: %1, %2</source>
        <translation>Bestes Gesetz nach AIC: %1, %2</translation>
    </message>
    <message>
        <source>Loading curves</source>
        <translation>Belastungskurven</translation>
    </message>
    <message>
        <source>Status of the fits</source>
        <translation>Status der Anpassungen</translation>
    </message>
    <message>
        <source>Stop and keep the fitted laws</source>
        <translation>Anhalten und die angepassten Gesetze behalten</translation>
    </message>
    <message>
        <source>Measured and fitted curves</source>
        <translation>Gemessene und angepasste Kurven</translation>
    </message>
    <message>
        <source>Drop a measured curve here, or choose it: columns of displacement and force, from rest or in cycles,
or k_e and d_e over amplitude. Fit draws the laws over it, with their residuals below.</source>
        <translation>Ziehen Sie eine gemessene Kurve hierher, oder wählen Sie sie: Spalten von Weg und Kraft, aus der Ruhe oder in Zyklen,
oder k_e und d_e über der Amplitude. „Anpassen“ zeichnet die Gesetze darüber, mit ihren Residuen darunter.</translation>
    </message>
    <message>
        <source>Curves and laws</source>
        <translation>Kurven und Gesetze</translation>
    </message>
    <message>
        <source>Fitting laws</source>
        <translation>Gesetze anpassen</translation>
    </message>
    <message>
        <source>Files…</source>
        <translation>Dateien …</translation>
    </message>
    <message>
        <source>Choose measured curves: text, MATLAB or HDF5 with columns</source>
        <translation>Gemessene Kurven wählen: Text, MATLAB oder HDF5 mit Spalten</translation>
    </message>
    <message>
        <source>Fit</source>
        <translation>Anpassen</translation>
    </message>
    <message>
        <source>Fit the laws to the curves</source>
        <translation>Die Gesetze an die Kurven anpassen</translation>
    </message>
    <message>
        <source>Copy as command</source>
        <translation>Als Befehl kopieren</translation>
    </message>
    <message>
        <source>Copy the command line with the same fit</source>
        <translation>Die Befehlszeile mit derselben Anpassung kopieren</translation>
    </message>
    <message>
        <source>Files</source>
        <translation>Dateien</translation>
    </message>
    <message>
        <source>Laws, best by AIC first; a row shows its parameters</source>
        <translation>Gesetze, das beste nach AIC zuerst; eine Zeile zeigt ihre Parameter</translation>
    </message>
    <message>
        <source>Parameters of the law with intervals</source>
        <translation>Parameter des Gesetzes mit Intervallen</translation>
    </message>
    <message>
        <source>k_e and d_e of the law over amplitude</source>
        <translation>k_e und d_e des Gesetzes über der Amplitude</translation>
    </message>
    <message>
        <source>Loops one by one</source>
        <translation>Schleifen einzeln</translation>
    </message>
    <message>
        <source>Laws and numbers</source>
        <translation>Gesetze und Zahlen</translation>
    </message>
    <message>
        <source>Laws</source>
        <translation>Gesetze</translation>
    </message>
    <message>
        <source>Parameters</source>
        <translation>Parameter</translation>
    </message>
    <message>
        <source>k_e and d_e</source>
        <translation>k_e und d_e</translation>
    </message>
    <message>
        <source>Loops</source>
        <translation>Schleifen</translation>
    </message>
    <message>
        <source>Columns: %1. Columns that you do not choose are found by name.</source>
        <translation>Spalten: %1. Nicht gewählte Spalten werden am Namen erkannt.</translation>
    </message>
    <message>
        <source>Fitting …</source>
        <translation>Wird angepasst …</translation>
    </message>
    <message>
        <source>curve</source>
        <translation>Kurve</translation>
    </message>
    <message>
        <source>k_e, d_e and energy</source>
        <translation>k_e, d_e und Energie</translation>
    </message>
    <message>
        <source>slip</source>
        <translation>Schlupf</translation>
    </message>
    <message>
        <source>loops in sequence</source>
        <translation>Schleifen der Reihe nach</translation>
    </message>
    <message>
        <source>Parameters of %1</source>
        <translation>Parameter von %1</translation>
    </message>
</context>
<context>
    <name>MainWindow</name>
    <message>
        <source>jointid workbench</source>
        <translation>jointid workbench</translation>
    </message>
    <message>
        <source>Getting started</source>
        <translation>Erste Schritte</translation>
    </message>
    <message>
        <source>Projects</source>
        <translation>Projekte</translation>
    </message>
    <message>
        <source>Projects, or getting started</source>
        <translation>Projekte, oder erste Schritte</translation>
    </message>
    <message>
        <source>Content</source>
        <translation>Inhalt</translation>
    </message>
    <message numerus="yes">
        <source>Reading %n file(s) …</source>
        <translation>
            <numerusform>Eine Datei wird gelesen …</numerusform>
            <numerusform>%n Dateien werden gelesen …</numerusform>
        </translation>
    </message>
    <message>
        <source>Save the scene</source>
        <translation>Die Szene speichern</translation>
    </message>
    <message>
        <source>Scenes (*.toml)</source>
        <translation>Szenen (*.toml)</translation>
    </message>
    <message>
        <source>Unsaved scene</source>
        <translation>Nicht gespeicherte Szene</translation>
    </message>
    <message>
        <source>Save the changes of %1?</source>
        <translation>Die Änderungen von %1 speichern?</translation>
    </message>
    <message>
        <source>%1[*] – jointid workbench</source>
        <translation>%1[*] – jointid workbench</translation>
    </message>
    <message>
        <source>The language changes with the next start.</source>
        <translation>Die Sprache wechselt mit dem nächsten Start.</translation>
    </message>
    <message>
        <source>Restart now</source>
        <translation>Jetzt neu starten</translation>
    </message>
    <message>
        <source>&amp;File</source>
        <translation>&amp;Datei</translation>
    </message>
    <message>
        <source>&amp;New scene</source>
        <translation>&amp;Neue Szene</translation>
    </message>
    <message>
        <source>&amp;Open…</source>
        <translation>Ö&amp;ffnen …</translation>
    </message>
    <message>
        <source>Open &amp;recent</source>
        <translation>&amp;Zuletzt geöffnet</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>&amp;Speichern</translation>
    </message>
    <message>
        <source>Save &amp;as…</source>
        <translation>Speichern &amp;unter …</translation>
    </message>
    <message>
        <source>Ctrl+Shift+S</source>
        <translation>Ctrl+Shift+S</translation>
    </message>
    <message>
        <source>&amp;Close</source>
        <translation>S&amp;chließen</translation>
    </message>
    <message>
        <source>Ctrl+W</source>
        <translation>Ctrl+W</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>&amp;Beenden</translation>
    </message>
    <message>
        <source>Ctrl+Q</source>
        <translation>Ctrl+Q</translation>
    </message>
    <message>
        <source>none yet</source>
        <translation>noch keine</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>&amp;Bearbeiten</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Rückgängig</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>&amp;Wiederholen</translation>
    </message>
    <message>
        <source>Go to &amp;error</source>
        <translation>Zum &amp;Fehler gehen</translation>
    </message>
    <message>
        <source>F8</source>
        <translation>F8</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>&amp;Ansicht</translation>
    </message>
    <message>
        <source>&amp;Light</source>
        <translation>&amp;Hell</translation>
    </message>
    <message>
        <source>&amp;Dark</source>
        <translation>&amp;Dunkel</translation>
    </message>
    <message>
        <source>&amp;Scene</source>
        <translation>S&amp;zene</translation>
    </message>
    <message>
        <source>Alt+1</source>
        <translation>Alt+1</translation>
    </message>
    <message>
        <source>Scene as a &amp;form</source>
        <translation>Szene als &amp;Formular</translation>
    </message>
    <message>
        <source>F4</source>
        <translation>F4</translation>
    </message>
    <message>
        <source>&amp;Data</source>
        <translation>D&amp;aten</translation>
    </message>
    <message>
        <source>&amp;Geometry</source>
        <translation>&amp;Geometrie</translation>
    </message>
    <message>
        <source>S&amp;olve</source>
        <translation>&amp;Lösen</translation>
    </message>
    <message>
        <source>&amp;Compare</source>
        <translation>&amp;Vergleich</translation>
    </message>
    <message>
        <source>S&amp;tudy</source>
        <translation>S&amp;tudie</translation>
    </message>
    <message>
        <source>Pl&amp;anning</source>
        <translation>Plan&amp;ung</translation>
    </message>
    <message>
        <source>&amp;Next project</source>
        <translation>&amp;Nächstes Projekt</translation>
    </message>
    <message>
        <source>Ctrl+Tab</source>
        <translation>Ctrl+Tab</translation>
    </message>
    <message>
        <source>&amp;Language</source>
        <translation>S&amp;prache</translation>
    </message>
    <message>
        <source>&amp;Run</source>
        <translation>&amp;Rechnen</translation>
    </message>
    <message>
        <source>&amp;Plan</source>
        <translation>&amp;Plan</translation>
    </message>
    <message>
        <source>F6</source>
        <translation>F6</translation>
    </message>
    <message>
        <source>&amp;Solve</source>
        <translation>&amp;Lösen</translation>
    </message>
    <message>
        <source>F5</source>
        <translation>F5</translation>
    </message>
    <message>
        <source>Predict &amp;bounds</source>
        <translation>&amp;Schranken vorhersagen</translation>
    </message>
    <message>
        <source>F7</source>
        <translation>F7</translation>
    </message>
    <message>
        <source>&amp;Cancel</source>
        <translation>&amp;Abbrechen</translation>
    </message>
    <message>
        <source>Shift+F5</source>
        <translation>Shift+F5</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>&amp;Hilfe</translation>
    </message>
    <message>
        <source>&amp;About</source>
        <translation>Ü&amp;ber</translation>
    </message>
    <message>
        <source>jointid workbench %1

Identifies joints from measured FRFs. Sources under BSD-3-Clause; this program links QCustomPlot and is passed on under the GPL, version 3.</source>
        <translation>jointid workbench %1

Identifiziert Fügestellen aus gemessenen FRFs. Quelltexte unter BSD-3-Clause; dieses Programm bindet QCustomPlot ein und wird unter der GPL, Version 3, weitergegeben.</translation>
    </message>
    <message>
        <source>&amp;Modes</source>
        <translation>&amp;Moden</translation>
    </message>
    <message>
        <source>Cou&amp;pling</source>
        <translation>&amp;Kopplung</translation>
    </message>
    <message>
        <source>C&amp;urves</source>
        <translation>K&amp;urven</translation>
    </message>
    <message>
        <source>&amp;Response</source>
        <translation>&amp;Antwort</translation>
    </message>
    <message>
        <source>La&amp;ws</source>
        <translation>&amp;Gesetze</translation>
    </message>
    <message>
        <source>Stic&amp;k-slip</source>
        <translation>Stic&amp;k-Slip</translation>
    </message>
    <message>
        <source>R&amp;ecords</source>
        <translation>V&amp;erläufe</translation>
    </message>
    <message>
        <source>These files have nodes and no FRFs.</source>
        <translation>Diese Dateien haben Knoten und keine FRFs.</translation>
    </message>
    <message>
        <source>&amp;Joint assistant…</source>
        <translation>&amp;Fügestellen-Assistent…</translation>
    </message>
    <message>
        <source>Ctrl+J</source>
        <translation>Ctrl+J</translation>
    </message>
    <message>
        <source>Data, Geometry and Modes show the file. Open those of the parts and of the assembly together for a joint.</source>
        <translation>Daten, Geometrie und Moden zeigen die Datei. Für eine Fügestelle öffnen Sie die der Substrukturen und des Zusammenbaus zusammen.</translation>
    </message>
    <message>
        <source>Data, Geometry and Modes show the files. %1</source>
        <translation>Daten, Geometrie und Moden zeigen die Dateien. %1</translation>
    </message>
    <message>
        <source>Drop FRF files of the substructures and of the assembly here, one file to look at, or a scene.

Ctrl+O opens files, Ctrl+N starts an empty scene, Ctrl+Shift+O opens an example.
File – New from template has scenes to be filled in.</source>
        <translation>Ziehen Sie FRF-Dateien der Teilstrukturen und der Gesamtstruktur hierher, eine einzelne Datei oder eine Szene.

Strg+O öffnet Dateien, Strg+N beginnt eine leere Szene, Strg+Umschalt+O öffnet ein Beispiel.
Datei – Neu aus Vorlage hat Szenen zum Ausfüllen.</translation>
    </message>
    <message>
        <source>%1, run %2</source>
        <translation>%1, Lauf %2</translation>
    </message>
    <message>
        <source>Writing the example …</source>
        <translation>Das Beispiel wird geschrieben …</translation>
    </message>
    <message>
        <source>Runs are lost</source>
        <translation>Läufe gehen verloren</translation>
    </message>
    <message>
        <source>Open &amp;example…</source>
        <translation>&amp;Beispiel öffnen…</translation>
    </message>
    <message>
        <source>Ctrl+Shift+O</source>
        <translation>Ctrl+Shift+O</translation>
    </message>
    <message>
        <source>New from &amp;template</source>
        <translation>Neu aus &amp;Vorlage</translation>
    </message>
    <message>
        <source>&amp;Two substructures and a joint</source>
        <translation>&amp;Zwei Teilstrukturen und eine Fuge</translation>
    </message>
    <message>
        <source>&amp;Coupling</source>
        <translation>&amp;Kopplung</translation>
    </message>
    <message>
        <source>&amp;Decoupling</source>
        <translation>&amp;Entkopplung</translation>
    </message>
    <message>
        <source>&amp;Isolator by virtual points</source>
        <translation>&amp;Isolator mit virtuellen Punkten</translation>
    </message>
    <message>
        <source>&amp;Friction from vibration</source>
        <translation>&amp;Reibung aus Schwingungen</translation>
    </message>
    <message>
        <source>&amp;Records to FRFs</source>
        <translation>&amp;Verläufe zu FRFs</translation>
    </message>
    <message>
        <source>Fold the te&amp;xt</source>
        <translation>Te&amp;xt einklappen</translation>
    </message>
    <message>
        <source>Ctrl+B</source>
        <translation>Ctrl+B</translation>
    </message>
    <message>
        <source>&amp;Documentation of this page</source>
        <translation>&amp;Dokumentation dieser Seite</translation>
    </message>
    <message>
        <source>F1</source>
        <translation>F1</translation>
    </message>
    <message>
        <source>The runs of %1 took %2. They are lost with it. Save the scene to keep them beside it. Close it?</source>
        <translation>Die Läufe von %1 dauerten %2. Sie gehen mit ihr verloren. Speichern der Szene bewahrt sie neben ihr auf. Schließen?</translation>
    </message>
    <message>
        <source>&amp;What&apos;s this?</source>
        <translation>&amp;Was ist das?</translation>
    </message>
    <message>
        <source>Shift+F1</source>
        <translation>Shift+F1</translation>
    </message>
    <message>
        <source>&amp;Z</source>
        <translation>&amp;Z</translation>
    </message>
</context>
<context>
    <name>MessageBar</name>
    <message>
        <source>Message</source>
        <translation>Meldung</translation>
    </message>
    <message>
        <source>Action that the message offers</source>
        <translation>Aktion, die die Meldung anbietet</translation>
    </message>
    <message>
        <source>Close the message</source>
        <translation>Die Meldung schließen</translation>
    </message>
</context>
<context>
    <name>ModalPage</name>
    <message>
        <source>Modes</source>
        <translation>Moden</translation>
    </message>
    <message>
        <source>Status of the modal fit</source>
        <translation>Status der Modalanalyse</translation>
    </message>
    <message>
        <source>Stop and keep the modes found so far</source>
        <translation>Anhalten und die bisher gefundenen Moden behalten</translation>
    </message>
    <message>
        <source>Stabilisation diagram</source>
        <translation>Stabilisierungsdiagramm</translation>
    </message>
    <message>
        <source>Find modes shows the poles of all orders here.
Click a pole to take it as a mode, or a pole of a mode to remove it; Ctrl+Z undoes.
← and → go from pole to pole, Enter is a click; wheel, + and − zoom.</source>
        <translation>„Moden suchen“ zeigt hier die Pole aller Ordnungen.
Ein Klick auf einen Pol nimmt ihn als Mode, ein Klick auf den einer Mode entfernt sie; Strg+Z macht rückgängig.
← und → gehen von Pol zu Pol, Eingabe ist ein Klick; Rad, + und − vergrößern.</translation>
    </message>
    <message>
        <source>Diagram and modes</source>
        <translation>Diagramm und Moden</translation>
    </message>
    <message>
        <source>Fitting modes</source>
        <translation>Moden anpassen</translation>
    </message>
    <message>
        <source>Find modes</source>
        <translation>Moden suchen</translation>
    </message>
    <message>
        <source>Find all modes above the noise</source>
        <translation>Alle Moden über dem Rauschen suchen</translation>
    </message>
    <message>
        <source>Substructure or assembly</source>
        <translation>Substruktur oder Zusammenbau</translation>
    </message>
    <message>
        <source>Lowest frequency</source>
        <translation>Kleinste Frequenz</translation>
    </message>
    <message>
        <source>from</source>
        <translation>von</translation>
    </message>
    <message>
        <source>Highest frequency</source>
        <translation>Größte Frequenz</translation>
    </message>
    <message>
        <source>to</source>
        <translation>bis</translation>
    </message>
    <message>
        <source>Damping</source>
        <translation>Dämpfung</translation>
    </message>
    <message>
        <source>Damping model of the modes</source>
        <translation>Dämpfungsmodell der Moden</translation>
    </message>
    <message>
        <source>real modes</source>
        <translation>reelle Moden</translation>
    </message>
    <message>
        <source>Real modes</source>
        <translation>Reelle Moden</translation>
    </message>
    <message>
        <source>All DOFs move in phase or in antiphase</source>
        <translation>Alle DOFs bewegen sich gleich- oder gegenphasig</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Rückgängig</translation>
    </message>
    <message>
        <source>Undo the last pick (Ctrl+Z in the diagram)</source>
        <translation>Die letzte Wahl rückgängig machen (Strg+Z im Diagramm)</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>Wiederholen</translation>
    </message>
    <message>
        <source>Pick again (Ctrl+Shift+Z in the diagram)</source>
        <translation>Wieder wählen (Strg+Umschalt+Z im Diagramm)</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Keine</translation>
    </message>
    <message>
        <source>Remove all modes, to pick poles one by one</source>
        <translation>Alle Moden entfernen, um Pole einzeln zu wählen</translation>
    </message>
    <message>
        <source>Copy as command</source>
        <translation>Als Befehl kopieren</translation>
    </message>
    <message>
        <source>Copy the command line with the same modes</source>
        <translation>Die Befehlszeile mit denselben Moden kopieren</translation>
    </message>
    <message>
        <source>Shapes…</source>
        <translation>Formen …</translation>
    </message>
    <message>
        <source>Write the mode shapes as `jointid modalfit --shapes` does (UFF 55)</source>
        <translation>Die Eigenformen schreiben wie `jointid modalfit --shapes` (UFF 55)</translation>
    </message>
    <message>
        <source>FRFs…</source>
        <translation>FRFs …</translation>
    </message>
    <message>
        <source>Write the synthesised FRFs as `jointid modalfit --regenerate` does</source>
        <translation>Die synthetisierten FRFs schreiben wie `jointid modalfit --regenerate`</translation>
    </message>
    <message>
        <source>Modes with standard errors. Delete removes one</source>
        <translation>Moden mit Standardfehlern. Entf entfernt eine</translation>
    </message>
    <message>
        <source>MAC of all modes</source>
        <translation>MAC aller Moden</translation>
    </message>
    <message>
        <source>Error of all FRFs in dB, without antiresonances</source>
        <translation>Fehler aller FRFs in dB, ohne Antiresonanzen</translation>
    </message>
    <message>
        <source>Modes and FRFs</source>
        <translation>Moden und FRFs</translation>
    </message>
    <message>
        <source>FRFs</source>
        <translation>FRFs</translation>
    </message>
    <message>
        <source>MAC</source>
        <translation>MAC</translation>
    </message>
    <message>
        <source>Errors</source>
        <translation>Fehler</translation>
    </message>
    <message>
        <source>Measured and synthesised FRFs</source>
        <translation>Gemessene und synthetisierte FRFs</translation>
    </message>
    <message>
        <source>Response</source>
        <translation>Antwort</translation>
    </message>
    <message>
        <source>Reference</source>
        <translation>Referenz</translation>
    </message>
    <message>
        <source>Find modes draws the FRFs synthesised from the modes over the measured ones. Every pick updates them.</source>
        <translation>„Moden suchen“ zeichnet die aus den Moden synthetisierten FRFs über die gemessenen. Jede Wahl erneuert sie.</translation>
    </message>
    <message>
        <source>Write the mode shapes</source>
        <translation>Die Eigenformen schreiben</translation>
    </message>
    <message>
        <source>Universal files (*.uff)</source>
        <translation>Universal Files (*.uff)</translation>
    </message>
    <message>
        <source>Write the synthesised FRFs</source>
        <translation>Die synthetisierten FRFs schreiben</translation>
    </message>
    <message>
        <source>FRFs (*.h5 *.uff *.mat *.csv)</source>
        <translation>FRFs (*.h5 *.uff *.mat *.csv)</translation>
    </message>
    <message>
        <source>Finding modes …</source>
        <translation>Moden werden gesucht …</translation>
    </message>
    <message numerus="yes">
        <source>%n mode(s); %1</source>
        <translation>
            <numerusform>Eine Mode; %1</numerusform>
            <numerusform>%n Moden; %1</numerusform>
        </translation>
    </message>
    <message>
        <source>No modes are found yet.</source>
        <translation>Noch keine Moden gefunden.</translation>
    </message>
    <message>
        <source>Written to %1.</source>
        <translation>Geschrieben nach %1.</translation>
    </message>
    <message>
        <source>Other modes</source>
        <translation>Andere Moden</translation>
    </message>
    <message>
        <source>MAC with other modes</source>
        <translation>MAC mit anderen Moden</translation>
    </message>
    <message>
        <source>Compare with…</source>
        <translation>Vergleichen mit…</translation>
    </message>
    <message>
        <source>About the pairs of modes</source>
        <translation>Zu den Paaren der Moden</translation>
    </message>
    <message>
        <source>MAC of the modes found with other modes</source>
        <translation>MAC der gefundenen mit anderen Moden</translation>
    </message>
    <message>
        <source>Compare with… draws the MAC of the modes found with those of a file.</source>
        <translation>Vergleichen mit… zeichnet den MAC der gefundenen Moden mit denen einer Datei.</translation>
    </message>
    <message>
        <source>Other modes, of another test or of a model: a universal file (UFF 55), or JSON of jointid modalfit</source>
        <translation>Andere Moden, eines anderen Versuchs oder eines Modells: eine Universaldatei (UFF 55) oder JSON von jointid modalfit</translation>
    </message>
</context>
<context>
    <name>MotionBar</name>
    <message>
        <source>Motion</source>
        <translation>Bewegung</translation>
    </message>
    <message>
        <source>Excitation or mode shape</source>
        <translation>Anregung oder Eigenform</translation>
    </message>
    <message>
        <source>A harmonic force at a reference of the assembly, or a mode shape from the page Modes or from a file</source>
        <translation>Eine harmonische Kraft an einer Referenz des Zusammenbaus, oder eine Eigenform von der Seite Moden oder aus einer Datei</translation>
    </message>
    <message>
        <source>Frequency of the force</source>
        <translation>Frequenz der Kraft</translation>
    </message>
    <message>
        <source>Follows the cursor of the plots</source>
        <translation>Folgt dem Zeiger der Diagramme</translation>
    </message>
    <message>
        <source> Hz</source>
        <translation> Hz</translation>
    </message>
    <message>
        <source>Move</source>
        <translation>Bewegen</translation>
    </message>
    <message>
        <source>Show the motion</source>
        <translation>Die Bewegung zeigen</translation>
    </message>
    <message>
        <source>Hold</source>
        <translation>Halten</translation>
    </message>
    <message>
        <source>Hold the motion at its phase</source>
        <translation>Die Bewegung bei ihrer Phase halten</translation>
    </message>
    <message>
        <source>Shapes…</source>
        <translation>Formen …</translation>
    </message>
    <message>
        <source>Amplitude</source>
        <translation>Amplitude</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Geschwindigkeit</translation>
    </message>
    <message>
        <source>Phase in degrees</source>
        <translation>Phase in Grad</translation>
    </message>
    <message>
        <source>joint</source>
        <translation>Fügestelle</translation>
    </message>
    <message>
        <source>Deflection of the joint</source>
        <translation>Verformung der Fügestelle</translation>
    </message>
    <message>
        <source>Show only the relative motion of the joint&apos;s nodes</source>
        <translation>Nur die Relativbewegung der Knoten der Fügestelle zeigen</translation>
    </message>
    <message>
        <source>undeformed</source>
        <translation>unverformt</translation>
    </message>
    <message>
        <source>Show the structure at rest, too</source>
        <translation>Auch die ruhende Struktur zeigen</translation>
    </message>
    <message>
        <source>numbers</source>
        <translation>Nummern</translation>
    </message>
    <message>
        <source>Show the numbers of nodes</source>
        <translation>Die Nummern der Knoten zeigen</translation>
    </message>
    <message>
        <source>amplitude</source>
        <translation>Amplitude</translation>
    </message>
    <message>
        <source>speed</source>
        <translation>Geschwindigkeit</translation>
    </message>
    <message>
        <source>phase</source>
        <translation>Phase</translation>
    </message>
    <message>
        <source>force at %1</source>
        <translation>Kraft an %1</translation>
    </message>
    <message>
        <source>mode %1</source>
        <translation>Mode %1</translation>
    </message>
    <message>
        <source>Read mode shapes from a universal file (dataset 55), or from JSON of jointid modalfit</source>
        <translation>Eigenformen aus einer Universaldatei (Dataset 55) oder aus JSON von jointid modalfit lesen</translation>
    </message>
</context>
<context>
    <name>OutputButtons</name>
    <message>
        <source>Save the results</source>
        <translation>Die Ergebnisse speichern</translation>
    </message>
    <message>
        <source>Report…</source>
        <translation>Bericht…</translation>
    </message>
    <message>
        <source>Save the page that the command writes with --report</source>
        <translation>Die Seite speichern, die der Befehl mit --report schreibt</translation>
    </message>
    <message>
        <source>JSON…</source>
        <translation>JSON…</translation>
    </message>
    <message>
        <source>Save what the command writes with --json</source>
        <translation>Speichern, was der Befehl mit --json schreibt</translation>
    </message>
    <message>
        <source>CSV…</source>
        <translation>CSV…</translation>
    </message>
    <message>
        <source>Save what the command writes with --csv</source>
        <translation>Speichern, was der Befehl mit --csv schreibt</translation>
    </message>
    <message>
        <source>Pages (*.html)</source>
        <translation>Seiten (*.html)</translation>
    </message>
    <message>
        <source>JSON (*.json)</source>
        <translation>JSON (*.json)</translation>
    </message>
    <message>
        <source>Tables (*.csv)</source>
        <translation>Tabellen (*.csv)</translation>
    </message>
    <message>
        <source>Written to %1.</source>
        <translation>Geschrieben nach %1.</translation>
    </message>
</context>
<context>
    <name>PlanPage</name>
    <message>
        <source>Test planning</source>
        <translation>Versuchsplanung</translation>
    </message>
    <message>
        <source>Status of the prediction</source>
        <translation>Status der Vorhersage</translation>
    </message>
    <message>
        <source>Smallest standard errors, and the effect of leaving out data</source>
        <translation>Kleinste Standardfehler, und was ein Weglassen von Daten ändert</translation>
    </message>
    <message>
        <source>Candidates, best first</source>
        <translation>Kandidaten, der beste zuerst</translation>
    </message>
    <message>
        <source>Bounds and candidates</source>
        <translation>Schranken und Kandidaten</translation>
    </message>
    <message>
        <source>This page shows the smallest standard errors that FRFs of a model or of an earlier test allow. It takes the joint of [truth] or [identify] start, and the noise of [noise] or of the files.</source>
        <translation>Diese Seite zeigt die kleinsten Standardfehler, die FRFs eines Modells oder einer früheren Messung zulassen. Sie nimmt die Fügestelle von [truth] oder [identify] start und das Rauschen von [noise] oder der Dateien.</translation>
    </message>
    <message>
        <source>Cancelled: nothing is predicted.</source>
        <translation>Abgebrochen: nichts ist vorhergesagt.</translation>
    </message>
    <message>
        <source>Predicting</source>
        <translation>Vorhersage</translation>
    </message>
    <message>
        <source>Predict</source>
        <translation>Vorhersagen</translation>
    </message>
    <message>
        <source>Predict the smallest standard errors and rank the candidates (F7)</source>
        <translation>Die kleinsten Standardfehler vorhersagen und die Kandidaten ordnen (F7)</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Stop and show the results so far</source>
        <translation>Anhalten und die bisherigen Ergebnisse zeigen</translation>
    </message>
    <message>
        <source>Candidates</source>
        <translation>Kandidaten</translation>
    </message>
    <message>
        <source>DOFs of the files that count as not measured. The plan predicts the benefit of each</source>
        <translation>DOFs der Dateien, die als nicht gemessen gelten. Der Plan sagt den Nutzen jedes DOFs voraus</translation>
    </message>
    <message>
        <source>candidates, not measured so far: 3:+Y, 4:+RZ</source>
        <translation>Kandidaten, bisher nicht gemessen: 3:+Y, 4:+RZ</translation>
    </message>
    <message>
        <source>DOFs to choose from</source>
        <translation>DOFs zur Auswahl</translation>
    </message>
    <message>
        <source>Copy as command</source>
        <translation>Als Befehl kopieren</translation>
    </message>
    <message>
        <source>Copy the command line with the same prediction</source>
        <translation>Die Befehlszeile mit derselben Vorhersage kopieren</translation>
    </message>
    <message>
        <source>Tables…</source>
        <translation>Tabellen …</translation>
    </message>
    <message>
        <source>Save both tables as CSV</source>
        <translation>Beide Tabellen als CSV speichern</translation>
    </message>
    <message>
        <source>Predicting …</source>
        <translation>Wird vorhergesagt …</translation>
    </message>
    <message>
        <source>Cancelled: some changes of the data are not predicted.</source>
        <translation>Abgebrochen: einige Änderungen der Daten sind nicht vorhergesagt.</translation>
    </message>
    <message>
        <source>Bounds are predicted.</source>
        <translation>Die Schranken sind vorhergesagt.</translation>
    </message>
    <message>
        <source>Save the tables</source>
        <translation>Die Tabellen speichern</translation>
    </message>
    <message>
        <source>Tables (*.csv)</source>
        <translation>Tabellen (*.csv)</translation>
    </message>
    <message>
        <source>SCENE.toml</source>
        <translation>SZENE.toml</translation>
    </message>
</context>
<context>
    <name>PlotCanvas</name>
    <message>
        <source>FRF plot</source>
        <translation>FRF-Diagramm</translation>
    </message>
</context>
<context>
    <name>PlotMenu</name>
    <message>
        <source>What is drawn</source>
        <translation>Was gezeichnet wird</translation>
    </message>
</context>
<context>
    <name>Project</name>
    <message>
        <source>Error in the scene</source>
        <translation>Fehler in der Szene</translation>
    </message>
    <message>
        <source>Scene and pages</source>
        <translation>Szene und Seiten</translation>
    </message>
    <message>
        <source>Project</source>
        <translation>Projekt</translation>
    </message>
    <message>
        <source>Scene as text or form</source>
        <translation>Szene als Text oder Formular</translation>
    </message>
    <message>
        <source>Text</source>
        <translation>Text</translation>
    </message>
    <message>
        <source>Form</source>
        <translation>Formular</translation>
    </message>
    <message>
        <source>Pages</source>
        <translation>Seiten</translation>
    </message>
    <message>
        <source>Data</source>
        <translation>Daten</translation>
    </message>
    <message>
        <source>Geometry</source>
        <translation>Geometrie</translation>
    </message>
    <message>
        <source>Solve</source>
        <translation>Lösen</translation>
    </message>
    <message>
        <source>Compare</source>
        <translation>Vergleich</translation>
    </message>
    <message>
        <source>Study</source>
        <translation>Studie</translation>
    </message>
    <message>
        <source>Test planning</source>
        <translation>Versuchsplanung</translation>
    </message>
    <message>
        <source>The scene is complete.</source>
        <translation>Die Szene ist vollständig.</translation>
    </message>
    <message>
        <source>Line %1: </source>
        <translation>Zeile %1: </translation>
    </message>
    <message>
        <source>it is larger than 16 MiB</source>
        <translation>sie ist größer als 16 MiB</translation>
    </message>
    <message>
        <source>it is not text in UTF-8</source>
        <translation>sie ist kein Text in UTF-8</translation>
    </message>
    <message>
        <source>new scene</source>
        <translation>neue Szene</translation>
    </message>
    <message>
        <source>%1 cannot be read: %2</source>
        <translation>%1 lässt sich nicht lesen: %2</translation>
    </message>
    <message>
        <source>%1 is gone or cannot be read: %2</source>
        <translation>%1 ist verschwunden oder lässt sich nicht lesen: %2</translation>
    </message>
    <message>
        <source>%1 was changed here and by another program.</source>
        <translation>%1 wurde hier und von einem anderen Programm geändert.</translation>
    </message>
    <message>
        <source>Load the file again</source>
        <translation>Die Datei neu laden</translation>
    </message>
    <message>
        <source>%1 was changed by another program and is loaded again.</source>
        <translation>%1 wurde von einem anderen Programm geändert und ist neu geladen.</translation>
    </message>
    <message>
        <source>Modes</source>
        <translation>Moden</translation>
    </message>
    <message>
        <source>Coupling</source>
        <translation>Kopplung</translation>
    </message>
    <message>
        <source>Loading curves</source>
        <translation>Belastungskurven</translation>
    </message>
    <message>
        <source>Response</source>
        <translation>Antwort</translation>
    </message>
    <message>
        <source>Curves</source>
        <translation>Kurven</translation>
    </message>
    <message>
        <source>Planning</source>
        <translation>Planung</translation>
    </message>
    <message>
        <source>Laws</source>
        <translation>Gesetze</translation>
    </message>
    <message>
        <source>Stick-slip</source>
        <translation>Stick-Slip</translation>
    </message>
    <message>
        <source>Time records</source>
        <translation>Zeitverläufe</translation>
    </message>
    <message>
        <source>Records</source>
        <translation>Verläufe</translation>
    </message>
    <message>
        <source>This scene is a proposal from the files. Its comments give the reasons. Check it, then save it.</source>
        <translation>Diese Szene ist ein Vorschlag aus den Dateien. Ihre Kommentare nennen die Gründe. Prüfen Sie sie und speichern Sie sie.</translation>
    </message>
    <message>
        <source>Joint assistant…</source>
        <translation>Fügestellen-Assistent…</translation>
    </message>
    <message>
        <source>The files are being read. Ask again in a moment.</source>
        <translation>Die Dateien werden gelesen. Versuchen Sie es gleich noch einmal.</translation>
    </message>
    <message>
        <source>The scene has several joints. Its form shows them one by one (F4).</source>
        <translation>Die Szene hat mehrere Fügestellen. Ihr Formular zeigt sie einzeln (F4).</translation>
    </message>
    <message>
        <source>The assistant joins two substructures or more. The scene has %1.</source>
        <translation>Der Assistent verbindet zwei oder mehr Substrukturen. Die Szene hat %1.</translation>
    </message>
    <message>
        <source>There is no scene. The pages Curves and Records need none.</source>
        <translation>Es gibt keine Szene. Die Seiten Kurven und Verläufe brauchen keine.</translation>
    </message>
    <message>
        <source>%1 was changed by another program, and is not saved over.</source>
        <translation>%1 wurde von einem anderen Programm geändert und nicht überschrieben.</translation>
    </message>
    <message>
        <source>Replace the file</source>
        <translation>Datei ersetzen</translation>
    </message>
    <message>
        <source>The command line is copied. It names the saved scene; your edits since are not in it. Ctrl+S saves them.</source>
        <translation>Die Befehlszeile ist kopiert. Sie nennt die gespeicherte Szene; Ihre Änderungen seither stehen nicht darin. Strg+S speichert sie.</translation>
    </message>
    <message>
        <source>%1 is in [data] %2 of the scene.</source>
        <translation>%1 steht in [data] %2 der Szene.</translation>
    </message>
    <message>
        <source>Z</source>
        <translation>Z</translation>
    </message>
</context>
<context>
    <name>QDoubleSpinBox</name>
    <message>
        <source>%1; 0: all lines</source>
        <translation>%1; 0: alle Linien</translation>
    </message>
    <message>
        <source>%1: all lines</source>
        <translation>%1: alle Linien</translation>
    </message>
</context>
<context>
    <name>QFileDialog</name>
    <message>
        <source>Scenes and FRFs (*.toml *.uff *.unv *.h5 *.hdf5 *.mat *.csv *.txt);;All files (*)</source>
        <translation>Szenen und FRFs (*.toml *.uff *.unv *.h5 *.hdf5 *.mat *.csv *.txt);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Öffnen</translation>
    </message>
    <message>
        <source>Mode shapes (*.uff *.unv *.json);;All files (*)</source>
        <translation>Eigenformen (*.uff *.unv *.json);;Alle Dateien (*)</translation>
    </message>
</context>
<context>
    <name>RecordsPage</name>
    <message>
        <source>Time records</source>
        <translation>Zeitverläufe</translation>
    </message>
    <message>
        <source>Status of the time records</source>
        <translation>Status der Zeitverläufe</translation>
    </message>
    <message>
        <source>Results of the time records</source>
        <translation>Ergebnisse der Zeitverläufe</translation>
    </message>
    <message>
        <source>Drop a time record here, or choose it: text, UFF 58, MATLAB, HDF5 or numpy, one column per channel.
Choose an analysis and the channels, then run it.</source>
        <translation>Einen Zeitverlauf hier ablegen oder wählen: Text, UFF 58, MATLAB, HDF5 oder numpy, jeder Kanal eine Spalte.
Eine Auswertung und die Kanäle wählen, dann ausführen.</translation>
    </message>
    <message>
        <source>Tables of the time records</source>
        <translation>Tabellen der Zeitverläufe</translation>
    </message>
    <message>
        <source>Options of the analysis</source>
        <translation>Optionen der Auswertung</translation>
    </message>
    <message>
        <source>Files…</source>
        <translation>Dateien…</translation>
    </message>
    <message>
        <source>Choose time records: text, UFF 58, MATLAB, HDF5 or numpy</source>
        <translation>Zeitverläufe wählen: Text, UFF 58, MATLAB, HDF5 oder numpy</translation>
    </message>
    <message>
        <source>Analysis of the time records</source>
        <translation>Auswertung der Zeitverläufe</translation>
    </message>
    <message>
        <source>Run</source>
        <translation>Ausführen</translation>
    </message>
    <message>
        <source>Run the analysis, as the command does</source>
        <translation>Die Auswertung ausführen, wie der Befehl es tut</translation>
    </message>
    <message>
        <source>Files</source>
        <translation>Dateien</translation>
    </message>
    <message>
        <source>Channels: %1</source>
        <translation>Kanäle: %1</translation>
    </message>
    <message>
        <source>%1 takes one file; %2 were opened.</source>
        <translation>%1 nimmt eine Datei; %2 wurden geöffnet.</translation>
    </message>
    <message>
        <source>What the FRFs are of</source>
        <translation>Wovon die FRFs sind</translation>
    </message>
    <message>
        <source>of a substructure</source>
        <translation>einer Teilstruktur</translation>
    </message>
    <message>
        <source>of the assembly</source>
        <translation>der Gesamtstruktur</translation>
    </message>
    <message>
        <source>To the scene…</source>
        <translation>In die Szene…</translation>
    </message>
    <message>
        <source>Write the FRFs into a file, and name it in [data] of the scene</source>
        <translation>Die FRFs in eine Datei schreiben und sie in [data] der Szene nennen</translation>
    </message>
    <message>
        <source>Save the FRFs</source>
        <translation>FRFs speichern</translation>
    </message>
    <message>
        <source>FRFs (*.h5 *.uff)</source>
        <translation>FRFs (*.h5 *.uff)</translation>
    </message>
    <message>
        <source>Written to %1.</source>
        <translation>Geschrieben nach %1.</translation>
    </message>
    <message>
        <source>record</source>
        <translation>Verlauf</translation>
    </message>
</context>
<context>
    <name>Said</name>
    <message>
        <source>Scene</source>
        <translation>Szene</translation>
    </message>
    <message>
        <source>Data</source>
        <translation>Daten</translation>
    </message>
    <message>
        <source>Frequencies</source>
        <translation>Frequenzen</translation>
    </message>
    <message>
        <source>Frequencies near resonances</source>
        <translation>Frequenzen nahe Resonanzen</translation>
    </message>
    <message>
        <source>Joint</source>
        <translation>Fügestelle</translation>
    </message>
    <message>
        <source>Joint: stiffness K</source>
        <translation>Fügestelle: Steifigkeit K</translation>
    </message>
    <message>
        <source>Joint: mass M</source>
        <translation>Fügestelle: Masse M</translation>
    </message>
    <message>
        <source>Joint: viscous damping C</source>
        <translation>Fügestelle: viskose Dämpfung C</translation>
    </message>
    <message>
        <source>Joint: hysteretic damping D</source>
        <translation>Fügestelle: hysteretische Dämpfung D</translation>
    </message>
    <message>
        <source>Identification</source>
        <translation>Identifikation</translation>
    </message>
    <message>
        <source>Identification: start</source>
        <translation>Identifikation: Startwerte</translation>
    </message>
    <message>
        <source>Noise</source>
        <translation>Rauschen</translation>
    </message>
    <message>
        <source>Noise: outlier lines</source>
        <translation>Rauschen: Ausreißer-Linien</translation>
    </message>
    <message>
        <source>Truth</source>
        <translation>Wahrheit</translation>
    </message>
    <message>
        <source>name of the scene</source>
        <translation>Name der Szene</translation>
    </message>
    <message>
        <source>positions in m: { &quot;4&quot; = [0.9, 0, 0], … }</source>
        <translation>Orte in m: { &quot;4&quot; = [0.9, 0, 0], … }</translation>
    </message>
    <message>
        <source>files of the substructures, without the joint</source>
        <translation>Dateien der Substrukturen, ohne die Fügestelle</translation>
    </message>
    <message>
        <source>files of the assembly, with the joint</source>
        <translation>Dateien des Zusammenbaus, mit der Fügestelle</translation>
    </message>
    <message>
        <source>positions of nodes: a table node, x [mm], y [mm], z [mm], or UFF</source>
        <translation>Orte der Knoten: eine Tabelle node, x [mm], y [mm], z [mm], oder UFF</translation>
    </message>
    <message>
        <source>positions of the nodes of this file: a table, or UFF</source>
        <translation>Orte der Knoten dieser Datei: eine Tabelle oder UFF</translation>
    </message>
    <message>
        <source>whether reciprocity replaces a missing FRF: H_ij by H_ji</source>
        <translation>ob Reziprozität eine fehlende FRF ersetzt: H_ij durch H_ji</translation>
    </message>
    <message>
        <source>FRFs to synthesise from modal models: substructures, assembly</source>
        <translation>aus Modalmodellen zu synthetisierende FRFs: substructures, assembly</translation>
    </message>
    <message>
        <source>missing information and corrections, file by file</source>
        <translation>fehlende Angaben und Korrekturen, Datei für Datei</translation>
    </message>
    <message>
        <source>lowest and highest frequency in Hz: 400, 1000</source>
        <translation>kleinste und größte Frequenz in Hz: 400, 1000</translation>
    </message>
    <message>
        <source>bands left out, in Hz: [[560, 566], [700, 702]]</source>
        <translation>ausgelassene Bänder in Hz: [[560, 566], [700, 702]]</translation>
    </message>
    <message>
        <source>lines near resonances left out: { of = [&quot;assembly&quot;], half_width = 0.01 }</source>
        <translation>ausgelassene Linien nahe Resonanzen: { of = [&quot;assembly&quot;], half_width = 0.01 }</translation>
    </message>
    <message>
        <source>whose resonances: substructures, assembly</source>
        <translation>wessen Resonanzen: substructures, assembly</translation>
    </message>
    <message>
        <source>half the width left out, relative: 0.01</source>
        <translation>halbe ausgelassene Breite, relativ: 0.01</translation>
    </message>
    <message>
        <source>interface DOFs of both sides: 4:+Y, 4:+RZ, 5:+Y, 5:+RZ</source>
        <translation>DOFs der Schnittstelle, beide Seiten: 4:+Y, 4:+RZ, 5:+Y, 5:+RZ</translation>
    </message>
    <message>
        <source>bands that are identified separately, in Hz: [[100, 200], [200, 400]]</source>
        <translation>einzeln identifizierte Bänder in Hz: [[100, 200], [200, 400]]</translation>
    </message>
    <message>
        <source>pairs coupled rigidly beforehand: [[&quot;4:+X&quot;, &quot;5:+X&quot;]]</source>
        <translation>vorher starr gekoppelte Paare: [[&quot;4:+X&quot;, &quot;5:+X&quot;]]</translation>
    </message>
    <message>
        <source>which elements are unknown</source>
        <translation>welche Elemente unbekannt sind</translation>
    </message>
    <message>
        <source>element by element: [[&quot;a&quot;, &quot;-a&quot;], [&quot;-a&quot;, &quot;a&quot;]]; numbers are known</source>
        <translation>Element für Element: [[&quot;a&quot;, &quot;-a&quot;], [&quot;-a&quot;, &quot;a&quot;]]; Zahlen sind bekannt</translation>
    </message>
    <message>
        <source>between two DOFs, or one and ground: [[&quot;4:+Y&quot;, &quot;5:+Y&quot;]]</source>
        <translation>zwischen zwei DOFs, oder einem und dem Boden: [[&quot;4:+Y&quot;, &quot;5:+Y&quot;]]</translation>
    </message>
    <message>
        <source>whether it is required to be positive semidefinite</source>
        <translation>ob sie positiv semidefinit sein muss</translation>
    </message>
    <message>
        <source>N/m, N, N·m: [[1e6, -1e6], [-1e6, 1e6]]</source>
        <translation>N/m, N, N·m: [[1e6, -1e6], [-1e6, 1e6]]</translation>
    </message>
    <message>
        <source>kg, kg·m, kg·m²: [[0, 0], [0, 0]]</source>
        <translation>kg, kg·m, kg·m²: [[0, 0], [0, 0]]</translation>
    </message>
    <message>
        <source>N·s/m, N·s, N·m·s: [[10, -10], [-10, 10]]</source>
        <translation>N·s/m, N·s, N·m·s: [[10, -10], [-10, 10]]</translation>
    </message>
    <message>
        <source>N/m, N, N·m: [[1e4, -1e4], [-1e4, 1e4]]</source>
        <translation>N/m, N, N·m: [[1e4, -1e4], [-1e4, 1e4]]</translation>
    </message>
    <message>
        <source>method of identification</source>
        <translation>Methode der Identifikation</translation>
    </message>
    <message>
        <source>blocks of the assembly to explain: nn, nj, jj, jn</source>
        <translation>zu erklärende Blöcke des Zusammenbaus: nn, nj, jj, jn</translation>
    </message>
    <message>
        <source>of the equations of linear methods</source>
        <translation>der Gleichungen linearer Methoden</translation>
    </message>
    <message>
        <source>drops equations whose sides differ by less than Δ: 0 to 2</source>
        <translation>lässt Gleichungen weg, deren Seiten sich um weniger als Δ unterscheiden: 0 bis 2</translation>
    </message>
    <message>
        <source>numerical solver of the method</source>
        <translation>numerischer Löser der Methode</translation>
    </message>
    <message>
        <source>start of iterations: { stiffness = [[1e6, -1e6], [-1e6, 1e6]] }</source>
        <translation>Startwerte der Iterationen: { stiffness = [[1e6, -1e6], [-1e6, 1e6]] }</translation>
    </message>
    <message>
        <source>how many starts are followed</source>
        <translation>wie viele Startwerte verfolgt werden</translation>
    </message>
    <message>
        <source>where the variances of the FRFs come from</source>
        <translation>woher die Varianzen der FRFs kommen</translation>
    </message>
    <message>
        <source>whether a noise model replaces the variances of files</source>
        <translation>ob ein Rauschmodell die Varianzen der Dateien ersetzt</translation>
    </message>
    <message>
        <source>prior knowledge, value and standard deviation: { &quot;K(1,1)&quot; = [6.6e5, 1e4] }</source>
        <translation>Vorwissen, Wert und Standardabweichung: { &quot;K(1,1)&quot; = [6.6e5, 1e4] }</translation>
    </message>
    <message>
        <source>of unknowns: { &quot;K(1,1)&quot; = [0, 1e6], &quot;D.a&quot; = &quot;positive&quot; }</source>
        <translation>von Unbekannten: { &quot;K(1,1)&quot; = [0, 1e6], &quot;D.a&quot; = &quot;positive&quot; }</translation>
    </message>
    <message>
        <source>equations between unknowns: [&quot;K(1,1) = K(3,3)&quot;]</source>
        <translation>Gleichungen zwischen Unbekannten: [&quot;K(1,1) = K(3,3)&quot;]</translation>
    </message>
    <message>
        <source>how many replicates: 0, or 100 and more</source>
        <translation>wie viele Wiederholungen: 0, oder 100 und mehr</translation>
    </message>
    <message>
        <source>of the random numbers of the bootstrap</source>
        <translation>der Zufallszahlen des Bootstraps</translation>
    </message>
    <message>
        <source>model of the measurement noise</source>
        <translation>Modell des Messrauschens</translation>
    </message>
    <message>
        <source>noise relative to |H|: 0.01</source>
        <translation>Rauschen, bezogen auf |H|: 0.01</translation>
    </message>
    <message>
        <source>of a hammer test: 0.998</source>
        <translation>eines Hammerversuchs: 0.998</translation>
    </message>
    <message>
        <source>of a hammer test: 5</source>
        <translation>eines Hammerversuchs: 5</translation>
    </message>
    <message>
        <source>of the averages: 0 to 1</source>
        <translation>der Mittelungen: 0 bis 1</translation>
    </message>
    <message>
        <source>constant noise relative to the rms of the FRF</source>
        <translation>konstantes Rauschen, bezogen auf den Effektivwert der FRF</translation>
    </message>
    <message>
        <source>outlier lines: { share = 0.02, factor = 10 }</source>
        <translation>Ausreißer-Linien: { share = 0.02, factor = 10 }</translation>
    </message>
    <message>
        <source>share of outlier lines: 0.02</source>
        <translation>Anteil der Ausreißer-Linien: 0.02</translation>
    </message>
    <message>
        <source>factor of their noise: 10</source>
        <translation>Faktor ihres Rauschens: 10</translation>
    </message>
    <message>
        <source>probability of a flipped sensor direction</source>
        <translation>Wahrscheinlichkeit einer vertauschten Sensorrichtung</translation>
    </message>
    <message>
        <source>standard deviation of a DOF&apos;s position, in m</source>
        <translation>Standardabweichung der Position eines DOFs, in m</translation>
    </message>
    <message>
        <source>whether reciprocal pairs H_ij, H_ji share their noise</source>
        <translation>ob reziproke Paare H_ij, H_ji ihr Rauschen teilen</translation>
    </message>
    <message>
        <source>planning</source>
        <translation>Planung</translation>
    </message>
    <message>
        <source>reading</source>
        <translation>Lesen</translation>
    </message>
    <message>
        <source>solving</source>
        <translation>Lösen</translation>
    </message>
    <message>
        <source>bootstrap</source>
        <translation>Bootstrap</translation>
    </message>
    <message>
        <source>identifiability</source>
        <translation>Identifizierbarkeit</translation>
    </message>
    <message>
        <source>trials</source>
        <translation>Versuche</translation>
    </message>
    <message>
        <source>constraining</source>
        <translation>Nebenbedingungen</translation>
    </message>
    <message>
        <source>standard errors</source>
        <translation>Standardfehler</translation>
    </message>
    <message>
        <source>Identifies joints from measured FRFs</source>
        <translation>Identifiziert Fügestellen aus gemessenen FRFs</translation>
    </message>
    <message>
        <source>scenes, or FRF files for a new scene</source>
        <translation>Szenen, oder FRF-Dateien für eine neue Szene</translation>
    </message>
    <message>
        <source>no longer determined</source>
        <translation>nicht mehr bestimmt</translation>
    </message>
    <message>
        <source>candidate</source>
        <translation>Kandidat</translation>
    </message>
    <message>
        <source>bounds times (mean)</source>
        <translation>Schranken mal (Mittel)</translation>
    </message>
    <message>
        <source>bounds times (worst)</source>
        <translation>Schranken mal (schlechteste)</translation>
    </message>
    <message>
        <source>benefit</source>
        <translation>Nutzen</translation>
    </message>
    <message>
        <source>computed over measured (dB)</source>
        <translation>berechnet zu gemessen (dB)</translation>
    </message>
    <message>
        <source>sum of |H|</source>
        <translation>Summe der |H|</translation>
    </message>
    <message>
        <source>real part</source>
        <translation>Realteil</translation>
    </message>
    <message>
        <source>imaginary part</source>
        <translation>Imaginärteil</translation>
    </message>
    <message>
        <source>not measured</source>
        <translation>nicht gemessen</translation>
    </message>
    <message>
        <source>… and %1 more</source>
        <translation>… und %1 weitere</translation>
    </message>
    <message>
        <source>%1 of %2 FRFs</source>
        <translation>%1 aus %2 FRFs</translation>
    </message>
    <message>
        <source>frequency (Hz)</source>
        <translation>Frequenz (Hz)</translation>
    </message>
    <message>
        <source>real part (%1)</source>
        <translation>Realteil (%1)</translation>
    </message>
    <message>
        <source>imaginary part (%1)</source>
        <translation>Imaginärteil (%1)</translation>
    </message>
    <message>
        <source>Pictures and tables (*.png *.svg *.pdf *.csv)</source>
        <translation>Bilder und Tabellen (*.png *.svg *.pdf *.csv)</translation>
    </message>
    <message>
        <source>Save the plot</source>
        <translation>Das Diagramm speichern</translation>
    </message>
    <message>
        <source>Not saved</source>
        <translation>Nicht gespeichert</translation>
    </message>
    <message>
        <source>status</source>
        <translation>Status</translation>
    </message>
    <message>
        <source>way</source>
        <translation>Weg</translation>
    </message>
    <message>
        <source>lines</source>
        <translation>Linien</translation>
    </message>
    <message>
        <source>assembly FRF error (dB)</source>
        <translation>FRF-Fehler des Zusammenbaus (dB)</translation>
    </message>
    <message>
        <source>χ² / degrees of freedom</source>
        <translation>χ² / Freiheitsgrade</translation>
    </message>
    <message>
        <source>run time (s)</source>
        <translation>Rechenzeit (s)</translation>
    </message>
    <message>
        <source>%1 of the selected run</source>
        <translation>%1 des gewählten Laufs</translation>
    </message>
    <message>
        <source>run </source>
        <translation>Lauf </translation>
    </message>
    <message>
        <source>assembly FRF error</source>
        <translation>FRF-Fehler des Zusammenbaus</translation>
    </message>
    <message>
        <source>outlier lines</source>
        <translation>Ausreißer-Linien</translation>
    </message>
    <message>
        <source>misfit</source>
        <translation>Abweichung</translation>
    </message>
    <message>
        <source>RJCF %1, ARVF %2, relative error %3 (rms)</source>
        <translation>RJCF %1, ARVF %2, relativer Fehler %3 (Effektivwert)</translation>
    </message>
    <message>
        <source>what</source>
        <translation>was</translation>
    </message>
    <message>
        <source>plan</source>
        <translation>Plan</translation>
    </message>
    <message>
        <source>method</source>
        <translation>Methode</translation>
    </message>
    <message>
        <source>solver</source>
        <translation>Löser</translation>
    </message>
    <message>
        <source>joint DOFs</source>
        <translation>DOFs der Fügestelle</translation>
    </message>
    <message>
        <source>internal responses</source>
        <translation>innere Antworten</translation>
    </message>
    <message>
        <source>internal references</source>
        <translation>innere Referenzen</translation>
    </message>
    <message>
        <source>%1, %2 to %3 Hz</source>
        <translation>%1, %2 bis %3 Hz</translation>
    </message>
    <message>
        <source>unknowns</source>
        <translation>Unbekannte</translation>
    </message>
    <message>
        <source>constraint</source>
        <translation>Nebenbedingung</translation>
    </message>
    <message>
        <source>to read</source>
        <translation>zu lesen</translation>
    </message>
    <message>
        <source>iterations expected</source>
        <translation>erwartete Iterationen</translation>
    </message>
    <message>
        <source>time expected</source>
        <translation>erwartete Zeit</translation>
    </message>
    <message>
        <source>left out</source>
        <translation>ausgelassen</translation>
    </message>
    <message>
        <source>warning</source>
        <translation>Warnung</translation>
    </message>
    <message>
        <source>note</source>
        <translation>Hinweis</translation>
    </message>
    <message>
        <source>of</source>
        <translation>von</translation>
    </message>
    <message>
        <source>standard error</source>
        <translation>Standardfehler</translation>
    </message>
    <message>
        <source>relative, or bounds times (worst)</source>
        <translation>relativ, oder Schranken mal (schlechteste)</translation>
    </message>
    <message>
        <source>smallest standard error</source>
        <translation>kleinster Standardfehler</translation>
    </message>
    <message>
        <source>not determined by the data</source>
        <translation>durch die Daten nicht bestimmt</translation>
    </message>
    <message>
        <source>without a DOF</source>
        <translation>ohne ein DOF</translation>
    </message>
    <message>
        <source>without lines</source>
        <translation>ohne Linien</translation>
    </message>
    <message>
        <source>with more data</source>
        <translation>mit mehr Daten</translation>
    </message>
    <message>
        <source>variances</source>
        <translation>Varianzen</translation>
    </message>
    <message>
        <source>name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>value</source>
        <translation>Wert</translation>
    </message>
    <message>
        <source>unit</source>
        <translation>Einheit</translation>
    </message>
    <message>
        <source>95 % interval or error</source>
        <translation>95-%-Intervall oder Fehler</translation>
    </message>
    <message>
        <source>remark</source>
        <translation>Bemerkung</translation>
    </message>
    <message>
        <source>value and interval</source>
        <translation>Wert und Intervall</translation>
    </message>
    <message>
        <source>finding</source>
        <translation>Befund</translation>
    </message>
    <message>
        <source>message</source>
        <translation>Meldung</translation>
    </message>
    <message>
        <source>chosen</source>
        <translation>gewählt</translation>
    </message>
    <message>
        <source>suspect</source>
        <translation>Verdacht</translation>
    </message>
    <message>
        <source>remedy</source>
        <translation>Abhilfe</translation>
    </message>
    <message>
        <source>measured</source>
        <translation>gemessen</translation>
    </message>
    <message>
        <source>synthesised</source>
        <translation>synthetisiert</translation>
    </message>
    <message>
        <source>trials: </source>
        <translation>Versuche: </translation>
    </message>
    <message>
        <source>so far</source>
        <translation>bisher</translation>
    </message>
    <message>
        <source>only the lines nearest to lo, lo + step, …, in Hz</source>
        <translation>nur die Linien, die lo, lo + step, … am nächsten sind, in Hz</translation>
    </message>
    <message>
        <source>FRF</source>
        <translation>FRF</translation>
    </message>
    <message>
        <source>error in dB (rms)</source>
        <translation>Fehler in dB (Effektivwert)</translation>
    </message>
    <message>
        <source>FRAC</source>
        <translation>FRAC</translation>
    </message>
    <message>
        <source>LAC, mean</source>
        <translation>LAC, Mittel</translation>
    </message>
    <message>
        <source>model of the same structure that the check compares: bracket.toml</source>
        <translation>Modell derselben Struktur, mit dem die Prüfung vergleicht: bracket.toml</translation>
    </message>
    <message>
        <source>resonance (Hz)</source>
        <translation>Resonanz (Hz)</translation>
    </message>
    <message>
        <source>with all compatibility conditions (Hz)</source>
        <translation>mit allen Kompatibilitätsbedingungen (Hz)</translation>
    </message>
    <message>
        <source>missing lines</source>
        <translation>fehlende Linien</translation>
    </message>
    <message>
        <source>mean coherence</source>
        <translation>mittlere Kohärenz</translation>
    </message>
    <message>
        <source>deviation over |H|</source>
        <translation>Abweichung über |H|</translation>
    </message>
    <message>
        <source>reciprocity error</source>
        <translation>Reziprozitätsfehler</translation>
    </message>
    <message>
        <source>coherence of %1 averages</source>
        <translation>Kohärenz aus %1 Mittelungen</translation>
    </message>
    <message>
        <source>noise not stated</source>
        <translation>Rauschen nicht angegeben</translation>
    </message>
    <message>
        <source>%1, %2 lines, %3 to %4 Hz; %5 × %6 FRFs; %7</source>
        <translation>%1, %2 Linien, %3 bis %4 Hz; %5 × %6 FRFs; %7</translation>
    </message>
    <message>
        <source>MAC of the modes at %1 and %2</source>
        <translation>MAC der Moden bei %1 und %2</translation>
    </message>
    <message>
        <source>by the modes</source>
        <translation>aus den Moden</translation>
    </message>
    <message>
        <source>uncertain gains and time delays of sensors: { gain = 0.01 }</source>
        <translation>unsichere Verstärkungen und Zeitverzögerungen von Sensoren: { gain = 0.01 }</translation>
    </message>
    <message>
        <source>mass loading by sensors, in kg, and its uncertainty</source>
        <translation>Massen von Sensoren, in kg, und ihre Unsicherheit</translation>
    </message>
    <message>
        <source>of studies: standard deviation of the gain of every sensor: 0.01</source>
        <translation>für Studien: Standardabweichung der Verstärkung jedes Sensors: 0.01</translation>
    </message>
    <message>
        <source>of studies: standard deviation of the mass of every sensor, in kg</source>
        <translation>für Studien: Standardabweichung der Masse jedes Sensors, in kg</translation>
    </message>
    <message>
        <source>Data: missing information and corrections of a file</source>
        <translation>Daten: fehlende Angaben und Korrekturen einer Datei</translation>
    </message>
    <message>
        <source>Joints</source>
        <translation>Fügestellen</translation>
    </message>
    <message>
        <source>receptance, mobility or accelerance, in place of the file&apos;s</source>
        <translation>receptance, mobility oder accelerance, anstelle der Angabe der Datei</translation>
    </message>
    <message>
        <source>of its responses: 4:+Y, 5:+Y</source>
        <translation>ihrer Antworten: 4:+Y, 5:+Y</translation>
    </message>
    <message>
        <source>of its references. Empty: those of the responses</source>
        <translation>ihrer Referenzen. Leer: die der Antworten</translation>
    </message>
    <message>
        <source>of its FRFs, if missing or wrong: g/lbf</source>
        <translation>ihrer FRFs, wenn sie fehlt oder falsch ist: g/lbf</translation>
    </message>
    <message>
        <source>variable of a MATLAB file with the FRFs</source>
        <translation>Variable einer MATLAB-Datei mit den FRFs</translation>
    </message>
    <message>
        <source>variable with its frequencies</source>
        <translation>Variable mit ihren Frequenzen</translation>
    </message>
    <message>
        <source>of the structure as weighed, hung free, in kg</source>
        <translation>der frei hängenden Struktur, gewogen, in kg</translation>
    </message>
    <message>
        <source>of its frequencies, if missing or wrong: kHz, rad/s</source>
        <translation>ihrer Frequenzen, wenn sie fehlt oder falsch ist: kHz, rad/s</translation>
    </message>
    <message>
        <source>true frequency divided by that of the file: 0.5 to 2</source>
        <translation>wahre Frequenz durch die der Datei: 0.5 bis 2</translation>
    </message>
    <message>
        <source>sensors: { &quot;OLD&quot; = &quot;NEW&quot; }, { &quot;4:+Y&quot; = &quot;5:+Y&quot; }</source>
        <translation>Sensoren: { &quot;ALT&quot; = &quot;NEU&quot; }, { &quot;4:+Y&quot; = &quot;5:+Y&quot; }</translation>
    </message>
    <message>
        <source>hammer or shaker: { &quot;4:+Y&quot; = &quot;5:+Y&quot; }</source>
        <translation>Hammer oder Shaker: { &quot;4:+Y&quot; = &quot;5:+Y&quot; }</translation>
    </message>
    <message>
        <source>whether the file has the complex conjugates</source>
        <translation>ob die Datei die konjugiert Komplexen hat</translation>
    </message>
    <message>
        <source>time delay of its responses, in s: 20e-6</source>
        <translation>Zeitverzögerung ihrer Antworten, in s: 20e-6</translation>
    </message>
    <message>
        <source>true FRF divided by that of the file: 9.80665, or { &quot;4:+Y&quot; = 1.02 }</source>
        <translation>wahre FRF durch die der Datei: 9.80665 oder { &quot;4:+Y&quot; = 1.02 }</translation>
    </message>
    <message>
        <source>of hammer or shaker: { &quot;4:+Y&quot; = 1.02 }</source>
        <translation>von Hammer oder Shaker: { &quot;4:+Y&quot; = 1.02 }</translation>
    </message>
    <message>
        <source>sensors with the wrong sign: 4:+Y</source>
        <translation>Sensoren mit falschem Vorzeichen: 4:+Y</translation>
    </message>
    <message>
        <source>directions of hammer or shaker with the wrong sign: 4:+Y</source>
        <translation>Richtungen von Hammer oder Shaker mit falschem Vorzeichen: 4:+Y</translation>
    </message>
    <message>
        <source>mass of the sensors, in kg: { &quot;4:+Y&quot; = 0.005 }</source>
        <translation>Masse der Sensoren, in kg: { &quot;4:+Y&quot; = 0.005 }</translation>
    </message>
    <message>
        <source>which of these masses are mounted at the same time</source>
        <translation>welche dieser Massen gleichzeitig montiert sind</translation>
    </message>
    <message>
        <source>of the joint, before its unknowns: left</source>
        <translation>der Fügestelle, vor ihren Unbekannten: left</translation>
    </message>
    <message>
        <source>laws compared</source>
        <translation>Gesetze im Vergleich</translation>
    </message>
    <message>
        <source>residuals by force level</source>
        <translation>Residuen nach Kraftniveau</translation>
    </message>
    <message>
        <source>%1 without a law</source>
        <translation>%1 ohne Gesetz</translation>
    </message>
    <message>
        <source>joint</source>
        <translation>Fügestelle</translation>
    </message>
    <message>
        <source>Friction laws</source>
        <translation>Reibgesetze</translation>
    </message>
    <message>
        <source>Identify laws</source>
        <translation>Gesetze identifizieren</translation>
    </message>
    <message>
        <source>Identify the friction laws of the joints from vibration at several force levels, as `jointid solve` does</source>
        <translation>Die Reibgesetze der Fügestellen aus Schwingungen bei mehreren Kraftniveaus identifizieren, wie `jointid solve`</translation>
    </message>
    <message>
        <source>Stiffness and damping of the joints over their motion</source>
        <translation>Steifigkeit und Dämpfung der Fügestellen über ihrer Bewegung</translation>
    </message>
    <message>
        <source>This page shows stiffness and damping of the joints over their motion, without a law and by the identified laws. It needs a scene with [[joint.friction]] and [[data.levels]].</source>
        <translation>Diese Seite zeigt Steifigkeit und Dämpfung der Fügestellen über ihrer Bewegung, ohne Gesetz und nach den identifizierten Gesetzen. Sie braucht eine Szene mit [[joint.friction]] und [[data.levels]].</translation>
    </message>
    <message>
        <source>Joints, laws, residuals</source>
        <translation>Fügestellen, Gesetze, Residuen</translation>
    </message>
    <message>
        <source>response</source>
        <translation>Antwort</translation>
    </message>
    <message>
        <source>peaks over force</source>
        <translation>Spitzen über der Kraft</translation>
    </message>
    <message>
        <source>harmonics</source>
        <translation>Harmonische</translation>
    </message>
    <message>
        <source>loop</source>
        <translation>Hysterese</translation>
    </message>
    <message>
        <source>curve</source>
        <translation>Kurve</translation>
    </message>
    <message>
        <source>equivalent joints</source>
        <translation>Ersatzfügestellen</translation>
    </message>
    <message>
        <source>clamping force</source>
        <translation>Klemmkraft</translation>
    </message>
    <message>
        <source>clamping force, %1 N</source>
        <translation>Klemmkraft, %1 N</translation>
    </message>
    <message>
        <source>motion</source>
        <translation>Bewegung</translation>
    </message>
    <message>
        <source>peaks</source>
        <translation>Spitzen</translation>
    </message>
    <message>
        <source>all points</source>
        <translation>alle Punkte</translation>
    </message>
    <message>
        <source>motions from rest</source>
        <translation>Bewegungen aus der Ruhe</translation>
    </message>
    <message>
        <source>remarks</source>
        <translation>Bemerkungen</translation>
    </message>
    <message>
        <source>Some results are missing. Tables and plots leave them out.</source>
        <translation>Einige Ergebnisse fehlen. Tabellen und Bilder lassen sie aus.</translation>
    </message>
    <message>
        <source>All results were found.</source>
        <translation>Alle Ergebnisse wurden gefunden.</translation>
    </message>
    <message>
        <source>Response</source>
        <translation>Antwort</translation>
    </message>
    <message>
        <source>Compute responses</source>
        <translation>Antworten berechnen</translation>
    </message>
    <message>
        <source>Compute the periodic responses and the other results of the scene, as `jointid response` does</source>
        <translation>Die periodischen Antworten und die anderen Ergebnisse der Szene berechnen, wie `jointid response`</translation>
    </message>
    <message>
        <source>Responses over frequency and force, loops, motions</source>
        <translation>Antworten über Frequenz und Kraft, Hysteresen, Bewegungen</translation>
    </message>
    <message>
        <source>This page shows the FRFs of a structure with friction joints at all force levels. It also shows peaks over the force level, harmonics, hysteresis loops and motions. It needs a scene with [structure] or [data] parts, [[joints]], [force] and [response].</source>
        <translation>Diese Seite zeigt die FRFs einer Struktur mit Reibfügestellen bei allen Kraftniveaus. Sie zeigt auch Spitzen über dem Kraftniveau, Harmonische, Hysteresen und Bewegungen. Sie braucht eine Szene mit [structure] oder [data] parts, [[joints]], [force] und [response].</translation>
    </message>
    <message>
        <source>Peaks, points, curves and remarks</source>
        <translation>Spitzen, Punkte, Kurven und Bemerkungen</translation>
    </message>
    <message>
        <source>Data: uncertain gains and time delays</source>
        <translation>Daten: unsichere Verstärkungen und Zeitverzögerungen</translation>
    </message>
    <message>
        <source>Data: mass loading by sensors</source>
        <translation>Daten: Massen der Sensoren</translation>
    </message>
    <message>
        <source>Virtual points</source>
        <translation>Virtuelle Punkte</translation>
    </message>
    <message>
        <source>DOFs of the sensors. Empty: all DOFs. 4:+Y, 5:+Y</source>
        <translation>DOFs der Sensoren. Leer: alle DOFs. 4:+Y, 5:+Y</translation>
    </message>
    <message>
        <source>files. Empty: all</source>
        <translation>Dateien. Leer: alle</translation>
    </message>
    <message>
        <source>of sensors (response), or of hammer and shaker (reference)</source>
        <translation>von Sensoren (response), oder von Hammer und Shaker (reference)</translation>
    </message>
    <message>
        <source>standard deviation of the gain about 1: 0.01</source>
        <translation>Standardabweichung der Verstärkung um 1: 0.01</translation>
    </message>
    <message>
        <source>standard deviation of the time delay about 0, in s: 1e-6</source>
        <translation>Standardabweichung der Zeitverzögerung um 0, in s: 1e-6</translation>
    </message>
    <message>
        <source>standard deviation of a sensor&apos;s misalignment, in rad: 0.02</source>
        <translation>Standardabweichung der Fehlausrichtung eines Sensors, in rad: 0.02</translation>
    </message>
    <message>
        <source>one error is shared by: files, nothing (none) or all</source>
        <translation>ein Fehler gilt gemeinsam für: Dateien (files), nichts (none) oder alles (all)</translation>
    </message>
    <message>
        <source>responses of the roving sensor: 4:+Y, 5:+Y</source>
        <translation>Antworten des wandernden Sensors: 4:+Y, 5:+Y</translation>
    </message>
    <message>
        <source>files</source>
        <translation>Dateien</translation>
    </message>
    <message>
        <source>of the sensor, in kg; its effect is removed: 0.003</source>
        <translation>des Sensors, in kg; ihre Wirkung wird herausgerechnet: 0.003</translation>
    </message>
    <message>
        <source>standard deviation of that mass, in kg. Empty: exactly known</source>
        <translation>Standardabweichung dieser Masse, in kg. Leer: genau bekannt</translation>
    </message>
    <message>
        <source>VP and a number: VP1</source>
        <translation>VP und eine Nummer: VP1</translation>
    </message>
    <message>
        <source>in m, the centre of its rotations: [0.9, 0, 0]</source>
        <translation>in m, der Mittelpunkt seiner Drehungen: [0.9, 0, 0]</translation>
    </message>
    <message>
        <source>for three motions only: the plane of its two translations</source>
        <translation>nur für drei Bewegungen: die Ebene seiner zwei Verschiebungen</translation>
    </message>
    <message>
        <source>interface deformation modes (flexible): ex, ey</source>
        <translation>Verformungsmoden der Schnittstelle (flexibel): ex, ey</translation>
    </message>
    <message>
        <source>responses around it: 11:+X, 11:+Y, 12:+Z</source>
        <translation>Antworten um ihn herum: 11:+X, 11:+Y, 12:+Z</translation>
    </message>
    <message>
        <source>references around it: 31:+X, 31:+Y, 32:+Z</source>
        <translation>Referenzen um ihn herum: 31:+X, 31:+Y, 32:+Z</translation>
    </message>
    <message>
        <source>of sensors not along an axis: { &quot;13:+Y&quot; = [0, 0.6, 0.8] }</source>
        <translation>von Sensoren nicht entlang einer Achse: { &quot;13:+Y&quot; = [0, 0.6, 0.8] }</translation>
    </message>
    <message>
        <source>of impacts not along an axis: { &quot;33:+Y&quot; = [0, 0.6, 0.8] }</source>
        <translation>von Schlägen nicht entlang einer Achse: { &quot;33:+Y&quot; = [0, 0.6, 0.8] }</translation>
    </message>
    <message>
        <source>of sensors in the fit: { &quot;13:+Y&quot; = 0.5 }</source>
        <translation>von Sensoren bei der Anpassung: { &quot;13:+Y&quot; = 0.5 }</translation>
    </message>
    <message>
        <source>of impacts in the fit: { &quot;33:+Y&quot; = 0.5 }</source>
        <translation>von Schlägen bei der Anpassung: { &quot;33:+Y&quot; = 0.5 }</translation>
    </message>
    <message>
        <source>files. Empty: all that have its sensors</source>
        <translation>Dateien. Leer: alle, die seine Sensoren haben</translation>
    </message>
    <message>
        <source>contact</source>
        <translation>Kontakt</translation>
    </message>
    <message>
        <source>proper orthogonal modes</source>
        <translation>orthogonale Moden (POD)</translation>
    </message>
    <message>
        <source>bifurcation diagram</source>
        <translation>Verzweigungsdiagramm</translation>
    </message>
    <message>
        <source>reduced models</source>
        <translation>reduzierte Modelle</translation>
    </message>
    <message>
        <source>results</source>
        <translation>Ergebnisse</translation>
    </message>
    <message>
        <source>periodic orbit</source>
        <translation>periodische Bahn</translation>
    </message>
    <message>
        <source>motion and orbit</source>
        <translation>Bewegung und Bahn</translation>
    </message>
    <message>
        <source>energy of modes</source>
        <translation>Anteile der Formen</translation>
    </message>
    <message>
        <source>mode shapes</source>
        <translation>Eigenformen</translation>
    </message>
    <message>
        <source>multipliers</source>
        <translation>Multiplikatoren</translation>
    </message>
    <message>
        <source>exponents</source>
        <translation>Exponenten</translation>
    </message>
    <message>
        <source>Stick-slip motion</source>
        <translation>Stick-Slip-Bewegung</translation>
    </message>
    <message>
        <source>Integrate</source>
        <translation>Integrieren</translation>
    </message>
    <message>
        <source>Integrate the motion exactly and compute the other results of the scene, as `jointid oscillate` does</source>
        <translation>Die Bewegung genau integrieren und die anderen Ergebnisse der Szene berechnen, wie `jointid oscillate`</translation>
    </message>
    <message>
        <source>Phase planes, contact, modes, bifurcations</source>
        <translation>Phasenebenen, Kontakt, Moden, Verzweigungen</translation>
    </message>
    <message>
        <source>This page shows phase planes and Poincaré sections of a system with one friction contact. It also shows the contact, proper orthogonal modes, the bifurcation diagram and reduced models. It needs a scene with [system], [friction] and [motion].</source>
        <translation>Diese Seite zeigt Phasenebenen und Poincaré-Schnitte eines Systems mit einem Reibkontakt. Sie zeigt auch den Kontakt, orthogonale Moden (POD), das Verzweigungsdiagramm und reduzierte Modelle. Sie braucht eine Szene mit [system], [friction] und [motion].</translation>
    </message>
    <message>
        <source>Orbit, modes, exponents, reduced models</source>
        <translation>Bahn, Moden, Exponenten, reduzierte Modelle</translation>
    </message>
    <message>
        <source>modes</source>
        <translation>Moden</translation>
    </message>
    <message>
        <source>values</source>
        <translation>Werte</translation>
    </message>
    <message>
        <source>comparison with other modes</source>
        <translation>Vergleich mit anderen Moden</translation>
    </message>
    <message>
        <source>delay and dimension</source>
        <translation>Verzögerung und Dimension</translation>
    </message>
    <message>
        <source>divergence</source>
        <translation>Divergenz</translation>
    </message>
    <message>
        <source>false nearest neighbours</source>
        <translation>falsche nächste Nachbarn</translation>
    </message>
    <message>
        <source>recurrences</source>
        <translation>Rekurrenzen</translation>
    </message>
    <message>
        <source>friction over velocity</source>
        <translation>Reibung über der Geschwindigkeit</translation>
    </message>
    <message>
        <source>law</source>
        <translation>Gesetz</translation>
    </message>
    <message>
        <source>Proper orthogonal modes</source>
        <translation>Orthogonale Moden (POD)</translation>
    </message>
    <message>
        <source>This page shows the proper orthogonal modes of the channels, with their shares of the mean square. Several files count as further samples.</source>
        <translation>Diese Seite zeigt die orthogonalen Moden (POD) der Kanäle mit ihren Anteilen am mittleren Quadrat. Mehrere Dateien gelten als weitere Abtastwerte.</translation>
    </message>
    <message>
        <source>channels</source>
        <translation>Kanäle</translation>
    </message>
    <message>
        <source>Channels. None chosen: all but the time</source>
        <translation>Kanäle. Keiner gewählt: alle außer der Zeit</translation>
    </message>
    <message>
        <source>mass matrix</source>
        <translation>Massenmatrix</translation>
    </message>
    <message>
        <source>File of the mass matrix of the channels, the inner product of the modes</source>
        <translation>Datei der Massenmatrix der Kanäle, des Skalarprodukts der Moden</translation>
    </message>
    <message>
        <source>stiffness matrix</source>
        <translation>Steifigkeitsmatrix</translation>
    </message>
    <message>
        <source>File of the stiffness matrix. With the mass matrix it gives cosines and MAC with the normal modes</source>
        <translation>Datei der Steifigkeitsmatrix. Mit der Massenmatrix ergibt sie Kosinus und MAC mit den Eigenmoden</translation>
    </message>
    <message>
        <source>other modes</source>
        <translation>andere Moden</translation>
    </message>
    <message>
        <source>File of modes: one column per mode, one row per channel. Gives cosines and MAC</source>
        <translation>Datei von Moden: je Mode eine Spalte, je Kanal eine Zeile. Ergibt Kosinus und MAC</translation>
    </message>
    <message>
        <source>keep the mean</source>
        <translation>Mittelwert behalten</translation>
    </message>
    <message>
        <source>Do not remove the mean of each channel</source>
        <translation>Den Mittelwert der Kanäle nicht abziehen</translation>
    </message>
    <message>
        <source>Delay and dimension</source>
        <translation>Verzögerung und Dimension</translation>
    </message>
    <message>
        <source>This page shows mutual information, false nearest neighbours, correlation sum and divergence of one channel.</source>
        <translation>Diese Seite zeigt Transinformation, falsche nächste Nachbarn, Korrelationssumme und Divergenz eines Kanals.</translation>
    </message>
    <message>
        <source>channel</source>
        <translation>Kanal</translation>
    </message>
    <message>
        <source>Channel. None chosen: the only one beside the time</source>
        <translation>Kanal. Keiner gewählt: der einzige neben der Zeit</translation>
    </message>
    <message>
        <source>samples per second</source>
        <translation>Abtastwerte je Sekunde</translation>
    </message>
    <message>
        <source>Samples per second, if the file does not state them</source>
        <translation>Abtastwerte je Sekunde, wenn die Datei sie nicht nennt</translation>
    </message>
    <message>
        <source>Number of samples from the start. The run time grows with its square</source>
        <translation>Zahl der Abtastwerte vom Anfang. Die Rechenzeit wächst mit ihrem Quadrat</translation>
    </message>
    <message>
        <source>delay</source>
        <translation>Verzögerung</translation>
    </message>
    <message>
        <source>Delay in samples. Empty: first minimum of the mutual information</source>
        <translation>Verzögerung in Abtastwerten. Leer: erstes Minimum der Transinformation</translation>
    </message>
    <message>
        <source>dimension</source>
        <translation>Dimension</translation>
    </message>
    <message>
        <source>Dimension. Empty: the smallest with at most 1 % false nearest neighbours</source>
        <translation>Dimension. Leer: die kleinste mit höchstens 1 % falschen nächsten Nachbarn</translation>
    </message>
    <message>
        <source>Theiler window</source>
        <translation>Theiler-Fenster</translation>
    </message>
    <message>
        <source>Smallest distance of neighbours in time, in samples. Empty: twice delay times dimension</source>
        <translation>Kleinster zeitlicher Abstand von Nachbarn, in Abtastwerten. Leer: zweimal Verzögerung mal Dimension</translation>
    </message>
    <message>
        <source>Friction of a contact</source>
        <translation>Reibung eines Kontakts</translation>
    </message>
    <message>
        <source>This page shows the friction coefficient over the relative velocity, and the fitted law.</source>
        <translation>Diese Seite zeigt den Reibwert über der Relativgeschwindigkeit und das angepasste Gesetz.</translation>
    </message>
    <message>
        <source>relative velocity</source>
        <translation>Relativgeschwindigkeit</translation>
    </message>
    <message>
        <source>Column of the relative velocity, m/s</source>
        <translation>Spalte der Relativgeschwindigkeit, m/s</translation>
    </message>
    <message>
        <source>friction force</source>
        <translation>Reibkraft</translation>
    </message>
    <message>
        <source>Column of the friction force, N, with the sign of the velocity while it slips</source>
        <translation>Spalte der Reibkraft, N, beim Gleiten mit dem Vorzeichen der Geschwindigkeit</translation>
    </message>
    <message>
        <source>normal load</source>
        <translation>Normallast</translation>
    </message>
    <message>
        <source>Column of the normal load, N, unless it is constant</source>
        <translation>Spalte der Normallast, N, wenn sie nicht konstant ist</translation>
    </message>
    <message>
        <source>constant load in N</source>
        <translation>feste Last in N</translation>
    </message>
    <message>
        <source>Constant normal load, N, instead of a column</source>
        <translation>Feste Normallast, N, statt einer Spalte</translation>
    </message>
    <message>
        <source>sticks below m/s</source>
        <translation>Haften unter m/s</translation>
    </message>
    <message>
        <source>Slower samples count as sticking, m/s. Choose it above the noise of the velocity</source>
        <translation>Langsamere Abtastwerte gelten als haftend, m/s. Über dem Rauschen der Geschwindigkeit wählen</translation>
    </message>
    <message>
        <source>delay of force in s</source>
        <translation>Verzögerung der Kraft in s</translation>
    </message>
    <message>
        <source>Time delay of the force, s; `jointid series align` finds it</source>
        <translation>Zeitverzögerung der Kraft, s; `jointid series align` findet sie</translation>
    </message>
    <message>
        <source>The laws are those of the scene (assumed).</source>
        <translation>Die Gesetze sind die der Szene (angenommen).</translation>
    </message>
    <message>
        <source>The laws are those of the measured force levels.</source>
        <translation>Die Gesetze sind die der gemessenen Kraftniveaus.</translation>
    </message>
    <message>
        <source>force level to measure next</source>
        <translation>als nächstes zu messendes Kraftniveau</translation>
    </message>
    <message>
        <source>benefit of each force level</source>
        <translation>Nutzen jedes Kraftniveaus</translation>
    </message>
    <message>
        <source>errors and intervals</source>
        <translation>Fehler und Intervalle</translation>
    </message>
    <message>
        <source>Laws</source>
        <translation>Gesetze</translation>
    </message>
    <message>
        <source>Bounds</source>
        <translation>Schranken</translation>
    </message>
    <message>
        <source>Predict bounds</source>
        <translation>Schranken vorhersagen</translation>
    </message>
    <message>
        <source>Predict the standard errors and the force level to measure next, as `jointid plan --bound` does</source>
        <translation>Die Standardfehler und das als nächstes zu messende Kraftniveau vorhersagen, wie `jointid plan --bound`</translation>
    </message>
    <message>
        <source>Study</source>
        <translation>Studie</translation>
    </message>
    <message>
        <source>Simulate tests</source>
        <translation>Versuche simulieren</translation>
    </message>
    <message>
        <source>Errors and coverage of the intervals over simulated tests, as `jointid study` does</source>
        <translation>Fehler und Überdeckung der Intervalle über simulierte Versuche, wie `jointid study`</translation>
    </message>
    <message>
        <source>displacements</source>
        <translation>Verschiebungen</translation>
    </message>
    <message>
        <source>points</source>
        <translation>Stellen</translation>
    </message>
    <message>
        <source>three periods</source>
        <translation>drei Perioden</translation>
    </message>
    <message>
        <source>delays</source>
        <translation>Zeitverzögerungen</translation>
    </message>
    <message>
        <source>Displacements from strain gauges</source>
        <translation>Verschiebungen aus Dehnungsmessstreifen</translation>
    </message>
    <message>
        <source>This page shows the displacements of a clamped beam, and their sensitivity to errors of the strains.</source>
        <translation>Diese Seite zeigt die Verschiebungen eines eingespannten Balkens und ihre Empfindlichkeit gegen Fehler der Dehnungen.</translation>
    </message>
    <message>
        <source>gauges&apos; channels</source>
        <translation>Kanäle der Streifen</translation>
    </message>
    <message>
        <source>Channels of the strain gauges. None chosen: all but the time</source>
        <translation>Kanäle der Dehnungsmessstreifen. Keiner gewählt: alle außer der Zeit</translation>
    </message>
    <message>
        <source>length in m</source>
        <translation>Länge in m</translation>
    </message>
    <message>
        <source>Length of the beam, m</source>
        <translation>Länge des Balkens, m</translation>
    </message>
    <message>
        <source>thickness in m</source>
        <translation>Dicke in m</translation>
    </message>
    <message>
        <source>Thickness of the beam, m. The strain is half of it times the curvature</source>
        <translation>Dicke des Balkens, m. Die Dehnung ist die Hälfte davon mal die Krümmung</translation>
    </message>
    <message>
        <source>gauges at m</source>
        <translation>Streifen bei m</translation>
    </message>
    <message>
        <source>Positions of the gauges, m from the clamp, in the order of their channels: 0.05,0.1</source>
        <translation>Positionen der Streifen, m von der Einspannung, in der Reihenfolge ihrer Kanäle: 0.05,0.1</translation>
    </message>
    <message>
        <source>points at m</source>
        <translation>Stellen bei m</translation>
    </message>
    <message>
        <source>Positions of the displacements, m. Empty: the tip</source>
        <translation>Positionen der Verschiebungen, m. Leer: das Ende</translation>
    </message>
    <message>
        <source>shapes</source>
        <translation>Formen</translation>
    </message>
    <message>
        <source>Number of shapes of the beam. Empty: that of the gauges</source>
        <translation>Zahl der Formen des Balkens. Leer: die der Streifen</translation>
    </message>
    <message>
        <source>static shapes</source>
        <translation>statische Formen</translation>
    </message>
    <message>
        <source>Two of the shapes are those of a tip force and a tip moment</source>
        <translation>Zwei der Formen sind die einer Kraft und eines Moments am Ende</translation>
    </message>
    <message>
        <source>Time delays of channels</source>
        <translation>Zeitverzögerungen von Kanälen</translation>
    </message>
    <message>
        <source>This page shows the channels of a periodic record, as measured and without their time delays.</source>
        <translation>Diese Seite zeigt die Kanäle eines periodischen Zeitverlaufs, gemessen und ohne ihre Zeitverzögerungen.</translation>
    </message>
    <message>
        <source>reference</source>
        <translation>Bezugskanal</translation>
    </message>
    <message>
        <source>Column without a time delay</source>
        <translation>Spalte ohne Zeitverzögerung</translation>
    </message>
    <message>
        <source>frequency in Hz</source>
        <translation>Frequenz in Hz</translation>
    </message>
    <message>
        <source>Frequency of the motion, Hz</source>
        <translation>Frequenz der Bewegung, Hz</translation>
    </message>
    <message>
        <source>Harmonics fitted together. Empty: 3</source>
        <translation>Gemeinsam angepasste Harmonische. Leer: 3</translation>
    </message>
    <message>
        <source>linear, between unknowns: [&quot;K(1,1) &gt;= 2*K(2,2)&quot;]</source>
        <translation>linear, zwischen Unbekannten: [&quot;K(1,1) &gt;= 2*K(2,2)&quot;]</translation>
    </message>
    <message>
        <source>band in Hz over which the damping of every joint is passive: 100, 400</source>
        <translation>Band in Hz, in dem die Dämpfung jeder Fügestelle passiv ist: 100, 400</translation>
    </message>
    <message>
        <source>eigenfrequencies of the assembly, in Hz: 83.2, 140.6</source>
        <translation>Eigenfrequenzen des Zusammenbaus, in Hz: 83.2, 140.6</translation>
    </message>
    <message>
        <source>whether joints with nominal stiffness are tested for being loose</source>
        <translation>ob Fügestellen mit nomineller Steifigkeit auf Lockerheit geprüft werden</translation>
    </message>
    <message>
        <source>spring</source>
        <translation>Feder</translation>
    </message>
    <message>
        <source>k</source>
        <translation>k</translation>
    </message>
    <message>
        <source>η = D/k</source>
        <translation>η = D/k</translation>
    </message>
    <message>
        <source>k beside the others of its direction</source>
        <translation>k neben den anderen seiner Richtung</translation>
    </message>
    <message>
        <source>%1 – %2: %3 of the others (%4)</source>
        <translation>%1 – %2: %3 der anderen (%4)</translation>
    </message>
    <message>
        <source>Loose, red: %1.</source>
        <translation>Lose, rot: %1.</translation>
    </message>
    <message>
        <source>Perhaps loose, brown: %1.</source>
        <translation>Vielleicht lose, braun: %1.</translation>
    </message>
    <message>
        <source>No spring is looser than half of the others of its direction.</source>
        <translation>Keine Feder ist lockerer als die Hälfte der anderen ihrer Richtung.</translation>
    </message>
    <message>
        <source>, Δ %1 Hz from %2 Hz</source>
        <translation>, Δ %1 Hz von %2 Hz</translation>
    </message>
    <message>
        <source>time (s)</source>
        <translation>Zeit (s)</translation>
    </message>
    <message>
        <source>phase (°)</source>
        <translation>Phase (°)</translation>
    </message>
    <message>
        <source>mode</source>
        <translation>Mode</translation>
    </message>
    <message>
        <source>force (N)</source>
        <translation>Kraft (N)</translation>
    </message>
    <message>
        <source>singular value</source>
        <translation>Singulärwert</translation>
    </message>
    <message>
        <source>shape</source>
        <translation>Form</translation>
    </message>
    <message>
        <source>relative velocity (m/s)</source>
        <translation>Relativgeschwindigkeit (m/s)</translation>
    </message>
    <message>
        <source>radius</source>
        <translation>Radius</translation>
    </message>
    <message>
        <source>over the amplitude</source>
        <translation>über der Amplitude</translation>
    </message>
    <message>
        <source>order (pole pairs)</source>
        <translation>Ordnung (Polpaare)</translation>
    </message>
    <message>
        <source>of critical (%)</source>
        <translation>der kritischen (%)</translation>
    </message>
    <message>
        <source>mean square λ</source>
        <translation>quadratisches Mittel λ</translation>
    </message>
    <message>
        <source>mean ln distance</source>
        <translation>mittlerer ln-Abstand</translation>
    </message>
    <message>
        <source>lag (s)</source>
        <translation>Verzögerung (s)</translation>
    </message>
    <message>
        <source>frequency lines used</source>
        <translation>verwendete Frequenzlinien</translation>
    </message>
    <message>
        <source>displacement (m)</source>
        <translation>Verschiebung (m)</translation>
    </message>
    <message>
        <source>coordinates</source>
        <translation>Koordinaten</translation>
    </message>
    <message>
        <source>condition number</source>
        <translation>Konditionszahl</translation>
    </message>
    <message>
        <source>coherence</source>
        <translation>Kohärenz</translation>
    </message>
    <message>
        <source>amplitude (m)</source>
        <translation>Amplitude (m)</translation>
    </message>
    <message>
        <source>receptance</source>
        <translation>Rezeptanz</translation>
    </message>
    <message>
        <source>mobility</source>
        <translation>Mobilität</translation>
    </message>
    <message>
        <source>accelerance</source>
        <translation>Akzeleranz</translation>
    </message>
    <message>
        <source>; %1 of %2 segments averaged</source>
        <translation>; %1 von %2 Abschnitten gemittelt</translation>
    </message>
    <message>
        <source>FRF and coherence</source>
        <translation>FRF und Kohärenz</translation>
    </message>
    <message>
        <source>record and windows</source>
        <translation>Zeitsignal und Fenster</translation>
    </message>
    <message>
        <source>segments</source>
        <translation>Abschnitte</translation>
    </message>
    <message>
        <source>coherences</source>
        <translation>Kohärenzen</translation>
    </message>
    <message>
        <source>averages</source>
        <translation>Mittelungen</translation>
    </message>
    <message>
        <source>Channels: COLUMN=DOF UNIT, parted by semicolons. Empty: as a universal file states them</source>
        <translation>Kanäle: SPALTE=DOF EINHEIT, durch Semikolon getrennt. Leer: wie die UFF-Datei sie nennt</translation>
    </message>
    <message>
        <source>force at</source>
        <translation>Kraft bei</translation>
    </message>
    <message>
        <source>DOF of the force, or one for each file, parted by commas</source>
        <translation>DOF der Kraft, oder einer je Datei, durch Komma getrennt</translation>
    </message>
    <message>
        <source>time</source>
        <translation>Zeit</translation>
    </message>
    <message>
        <source>Column of the times, if its title does not state them</source>
        <translation>Spalte der Zeiten, wenn ihr Titel es nicht sagt</translation>
    </message>
    <message>
        <source>segment in s</source>
        <translation>Abschnitt in s</translation>
    </message>
    <message>
        <source>Length of a segment, s. Empty: each whole file is one impact</source>
        <translation>Länge eines Abschnitts, s. Leer: jede ganze Datei ist ein Schlag</translation>
    </message>
    <message>
        <source>pretrigger in s</source>
        <translation>Vorlauf in s</translation>
    </message>
    <message>
        <source>Time before the trigger that belongs to the segment, s</source>
        <translation>Zeit vor dem Trigger, die zum Abschnitt gehört, s</translation>
    </message>
    <message>
        <source>trigger: 0.1</source>
        <translation>Trigger: 0.1</translation>
    </message>
    <message>
        <source>An impact begins at this share of the largest force</source>
        <translation>Ein Schlag beginnt bei diesem Anteil der größten Kraft</translation>
    </message>
    <message>
        <source>double impact: 0.1</source>
        <translation>Doppelschlag: 0.1</translation>
    </message>
    <message>
        <source>A force above this share of the peak is a double impact</source>
        <translation>Eine Kraft über diesem Anteil der Spitze ist ein Doppelschlag</translation>
    </message>
    <message>
        <source>force window in s</source>
        <translation>Kraftfenster in s</translation>
    </message>
    <message>
        <source>Seconds after its peak for which the force counts</source>
        <translation>Sekunden nach ihrer Spitze, in denen die Kraft zählt</translation>
    </message>
    <message>
        <source>exponential in s</source>
        <translation>Exponentiell in s</translation>
    </message>
    <message>
        <source>Time constant of an exponential window, s. The damping that it adds is taken out again</source>
        <translation>Zeitkonstante eines Exponentialfensters, s. Die Dämpfung, die es zufügt, wird wieder entfernt</translation>
    </message>
    <message>
        <source>leave out: 2,5</source>
        <translation>weglassen: 2,5</translation>
    </message>
    <message>
        <source>Segments to leave out, by their number in the table</source>
        <translation>Abschnitte, die wegbleiben, nach ihrer Nummer in der Tabelle</translation>
    </message>
    <message>
        <source>keep faulty</source>
        <translation>Fehlerhafte behalten</translation>
    </message>
    <message>
        <source>Also average overloads and double impacts</source>
        <translation>Auch Übersteuerungen und Doppelschläge mitteln</translation>
    </message>
    <message>
        <source>shaker</source>
        <translation>Shaker</translation>
    </message>
    <message>
        <source>Segments of a long record in place of impacts</source>
        <translation>Abschnitte eines langen Zeitsignals statt Schläge</translation>
    </message>
    <message>
        <source>overlap: 0.5</source>
        <translation>Überlappung: 0.5</translation>
    </message>
    <message>
        <source>Share by which the segments of a shaker overlap</source>
        <translation>Anteil, um den die Abschnitte eines Shakers überlappen</translation>
    </message>
    <message>
        <source>remove the mean</source>
        <translation>Mittelwert abziehen</translation>
    </message>
    <message>
        <source>Subtract the mean of every segment</source>
        <translation>Den Mittelwert jedes Abschnitts abziehen</translation>
    </message>
    <message>
        <source>Estimator: H1, H2 or Hv</source>
        <translation>Schätzer: H1, H2 oder Hv</translation>
    </message>
    <message>
        <source>highest line in Hz</source>
        <translation>höchste Linie in Hz</translation>
    </message>
    <message>
        <source>Highest line of the FRFs, Hz</source>
        <translation>Höchste Linie der FRFs, Hz</translation>
    </message>
    <message>
        <source>FRFs of impacts or a shaker</source>
        <translation>FRFs aus Schlägen oder Shaker</translation>
    </message>
    <message>
        <source>This page shows FRFs with coherence, the records with their windows, and why segments are left out. After the first run it follows what you set. “To the scene…” writes the FRFs and names them in [data].</source>
        <translation>Diese Seite zeigt FRFs mit Kohärenz, die Zeitsignale mit ihren Fenstern, und warum Abschnitte wegbleiben. Nach dem ersten Lauf folgt sie dem, was Sie einstellen. „In die Szene…“ schreibt die FRFs und nennt sie in [data].</translation>
    </message>
    <message>
        <source>other run</source>
        <translation>anderer Lauf</translation>
    </message>
    <message>
        <source>this run</source>
        <translation>dieser Lauf</translation>
    </message>
    <message>
        <source>difference</source>
        <translation>Unterschied</translation>
    </message>
    <message>
        <source>of the other</source>
        <translation>des anderen</translation>
    </message>
    <message>
        <source>differs</source>
        <translation>verschieden</translation>
    </message>
    <message>
        <source>no intervals</source>
        <translation>keine Intervalle</translation>
    </message>
    <message>
        <source>yes</source>
        <translation>ja</translation>
    </message>
    <message>
        <source>within the intervals</source>
        <translation>innerhalb der Intervalle</translation>
    </message>
    <message>
        <source>modes of %1</source>
        <translation>Moden von %1</translation>
    </message>
    <message>
        <source>modes found</source>
        <translation>gefundene Moden</translation>
    </message>
    <message>
        <source>%1 of %2 modes have a partner with a MAC of one half at least, over %3 DOFs that both sets have.</source>
        <translation>%1 von %2 Moden haben einen Partner mit einem MAC von mindestens 0,5, über %3 Freiheitsgrade, die beide haben.</translation>
    </message>
    <message>
        <source>map over force levels: %1</source>
        <translation>Karte über Kraftniveaus: %1</translation>
    </message>
    <message>
        <source>force level</source>
        <translation>Kraftniveau</translation>
    </message>
    <message>
        <source>misfit by line</source>
        <translation>Misfit je Linie</translation>
    </message>
    <message>
        <source>parameters of the best law</source>
        <translation>Parameter des besten Gesetzes</translation>
    </message>
    <message>
        <source>Joint line by line</source>
        <translation>Fügestelle Linie für Linie</translation>
    </message>
    <message>
        <source>Z over frequency</source>
        <translation>Z über der Frequenz</translation>
    </message>
    <message>
        <source>Find Z</source>
        <translation>Z finden</translation>
    </message>
    <message>
        <source>Find the dynamic stiffness of the joint at every line, as `jointid solve` does</source>
        <translation>Die dynamische Steifigkeit der Fügestelle an jeder Linie finden, wie `jointid solve`</translation>
    </message>
    <message>
        <source>Dynamic stiffness of the joint over frequency</source>
        <translation>Dynamische Steifigkeit der Fügestelle über der Frequenz</translation>
    </message>
    <message>
        <source>This page shows the dynamic stiffness Z of the joint at every line, with 95 % bands, loss factors and laws. It needs a scene with [joint] lines.</source>
        <translation>Diese Seite zeigt die dynamische Steifigkeit Z der Fügestelle an jeder Linie, mit 95-%-Bändern, Verlustfaktoren und Gesetzen. Sie braucht eine Szene mit [joint] lines.</translation>
    </message>
    <message>
        <source>Elements of Z, laws</source>
        <translation>Elemente von Z, Gesetze</translation>
    </message>
    <message>
        <source>Pictures, tables and films (*.png *.svg *.pdf *.csv *.gif)</source>
        <translation>Bilder, Tabellen und Filme (*.png *.svg *.pdf *.csv *.gif)</translation>
    </message>
    <message>
        <source>Geometry</source>
        <translation>Geometrie</translation>
    </message>
    <message>
        <source>lines of the picture between nodes: [[4, 5], [5, 12]]</source>
        <translation>Linien des Bilds zwischen Knoten: [[4, 5], [5, 12]]</translation>
    </message>
    <message>
        <source>Line %1. Delete removes it.</source>
        <translation>Linie %1. Entf entfernt sie.</translation>
    </message>
    <message>
        <source>Line %1 is one of the files.</source>
        <translation>Linie %1 ist aus den Dateien.</translation>
    </message>
    <message>
        <source>A line from node %1. Pick the other node, or press Esc.</source>
        <translation>Eine Linie von Knoten %1. Den anderen Knoten wählen oder Esc drücken.</translation>
    </message>
    <message>
        <source>Pick two nodes for a line between them: by click, or by Page Up, Page Down and Space. A click on a line chooses it.</source>
        <translation>Zwei Knoten für eine Linie wählen: mit der Maus oder mit Bild auf, Bild ab und Leertaste. Ein Klick auf eine Linie wählt sie.</translation>
    </message>
    <message>
        <source>time of one solution</source>
        <translation>Zeit einer Lösung</translation>
    </message>
    <message>
        <source>rms relative error (median)</source>
        <translation>mittlerer relativer Fehler (Median)</translation>
    </message>
    <message>
        <source>value / value of the solution</source>
        <translation>Wert / Wert der Lösung</translation>
    </message>
    <message>
        <source>objective</source>
        <translation>Zielfunktion</translation>
    </message>
    <message>
        <source>iteration</source>
        <translation>Iteration</translation>
    </message>
    <message>
        <source>displacement</source>
        <translation>Weg</translation>
    </message>
    <message>
        <source>amplitude</source>
        <translation>Amplitude</translation>
    </message>
    <message>
        <source>force</source>
        <translation>Kraft</translation>
    </message>
    <message>
        <source>energy</source>
        <translation>Energie</translation>
    </message>
    <message>
        <source>frequency</source>
        <translation>Frequenz</translation>
    </message>
    <message>
        <source>slipped share h of the stiffness area</source>
        <translation>gerutschter Anteil h der Steifigkeitsfläche</translation>
    </message>
    <message>
        <source>sample</source>
        <translation>Abtastwert</translation>
    </message>
    <message>
        <source>95 % interval</source>
        <translation>95-%-Intervall</translation>
    </message>
    <message>
        <source>95 % of lines</source>
        <translation>95 % der Linien</translation>
    </message>
    <message>
        <source>AIC − least</source>
        <translation>AIC − kleinster</translation>
    </message>
    <message>
        <source>FRF of B</source>
        <translation>FRF von B</translation>
    </message>
    <message>
        <source>Newton steps</source>
        <translation>Newton-Schritte</translation>
    </message>
    <message>
        <source>amplitude m</source>
        <translation>Amplitude m</translation>
    </message>
    <message>
        <source>answers</source>
        <translation>Antworten</translation>
    </message>
    <message>
        <source>apart</source>
        <translation>Abstand</translation>
    </message>
    <message>
        <source>assumed</source>
        <translation>angenommen</translation>
    </message>
    <message>
        <source>at sample</source>
        <translation>bei Abtastwert</translation>
    </message>
    <message>
        <source>away from antiresonances</source>
        <translation>abseits der Antiresonanzen</translation>
    </message>
    <message>
        <source>best determined of these</source>
        <translation>am besten bestimmt</translation>
    </message>
    <message>
        <source>bias</source>
        <translation>Abweichung</translation>
    </message>
    <message>
        <source>bias %</source>
        <translation>Abweichung %</translation>
    </message>
    <message>
        <source>calibration</source>
        <translation>Kalibrierung</translation>
    </message>
    <message>
        <source>chance</source>
        <translation>Zufall</translation>
    </message>
    <message>
        <source>closest</source>
        <translation>nächste</translation>
    </message>
    <message>
        <source>coherence, mean</source>
        <translation>Kohärenz, Mittel</translation>
    </message>
    <message>
        <source>condition</source>
        <translation>Kondition</translation>
    </message>
    <message>
        <source>coordinate</source>
        <translation>Koordinate</translation>
    </message>
    <message>
        <source>correlation</source>
        <translation>Korrelation</translation>
    </message>
    <message>
        <source>cost</source>
        <translation>Kosten</translation>
    </message>
    <message>
        <source>dB rms</source>
        <translation>dB eff.</translation>
    </message>
    <message>
        <source>damping</source>
        <translation>Dämpfung</translation>
    </message>
    <message>
        <source>degrees</source>
        <translation>Grad</translation>
    </message>
    <message>
        <source>element</source>
        <translation>Element</translation>
    </message>
    <message>
        <source>ended</source>
        <translation>Ende</translation>
    </message>
    <message>
        <source>equations</source>
        <translation>Gleichungen</translation>
    </message>
    <message>
        <source>error of X</source>
        <translation>Fehler von X</translation>
    </message>
    <message>
        <source>error of the measurement</source>
        <translation>Fehler der Messung</translation>
    </message>
    <message>
        <source>error, dB</source>
        <translation>Fehler, dB</translation>
    </message>
    <message>
        <source>exponent</source>
        <translation>Exponent</translation>
    </message>
    <message>
        <source>file</source>
        <translation>Datei</translation>
    </message>
    <message>
        <source>freedom</source>
        <translation>Freiheitsgrade</translation>
    </message>
    <message>
        <source>frequency, Hz</source>
        <translation>Frequenz, Hz</translation>
    </message>
    <message>
        <source>friction limit</source>
        <translation>Reibgrenze</translation>
    </message>
    <message>
        <source>how often</source>
        <translation>wie oft</translation>
    </message>
    <message>
        <source>imaginary</source>
        <translation>Imaginärteil</translation>
    </message>
    <message>
        <source>increments</source>
        <translation>Schritte</translation>
    </message>
    <message>
        <source>initial stiffness</source>
        <translation>Anfangssteifigkeit</translation>
    </message>
    <message>
        <source>kept</source>
        <translation>behalten</translation>
    </message>
    <message>
        <source>largest</source>
        <translation>größte</translation>
    </message>
    <message>
        <source>late by s</source>
        <translation>später um s</translation>
    </message>
    <message>
        <source>least determined</source>
        <translation>am wenigsten bestimmt</translation>
    </message>
    <message>
        <source>level</source>
        <translation>Stufe</translation>
    </message>
    <message>
        <source>loss factor</source>
        <translation>Verlustfaktor</translation>
    </message>
    <message>
        <source>matrix</source>
        <translation>Matrix</translation>
    </message>
    <message>
        <source>mean</source>
        <translation>Mittel</translation>
    </message>
    <message>
        <source>median</source>
        <translation>Median</translation>
    </message>
    <message>
        <source>median %</source>
        <translation>Median %</translation>
    </message>
    <message>
        <source>minimum</source>
        <translation>Minimum</translation>
    </message>
    <message>
        <source>modulus</source>
        <translation>Betrag</translation>
    </message>
    <message>
        <source>most alike</source>
        <translation>am ähnlichsten</translation>
    </message>
    <message>
        <source>most changed</source>
        <translation>am stärksten geändert</translation>
    </message>
    <message>
        <source>most of it</source>
        <translation>größter Anteil</translation>
    </message>
    <message>
        <source>multiplier</source>
        <translation>Multiplikator</translation>
    </message>
    <message>
        <source>pairs</source>
        <translation>Paare</translation>
    </message>
    <message>
        <source>parameter</source>
        <translation>Parameter</translation>
    </message>
    <message>
        <source>parameters</source>
        <translation>Parameter</translation>
    </message>
    <message>
        <source>partner, Hz</source>
        <translation>Partner, Hz</translation>
    </message>
    <message>
        <source>period s</source>
        <translation>Periode s</translation>
    </message>
    <message>
        <source>period samples</source>
        <translation>Periode, Abtastwerte</translation>
    </message>
    <message>
        <source>prior</source>
        <translation>Vorwissen</translation>
    </message>
    <message>
        <source>probability</source>
        <translation>Wahrscheinlichkeit</translation>
    </message>
    <message>
        <source>real</source>
        <translation>Realteil</translation>
    </message>
    <message>
        <source>relative</source>
        <translation>relativ</translation>
    </message>
    <message>
        <source>replaced</source>
        <translation>ersetzt</translation>
    </message>
    <message>
        <source>rms error</source>
        <translation>mittlerer Fehler</translation>
    </message>
    <message>
        <source>rms error %</source>
        <translation>mittlerer Fehler %</translation>
    </message>
    <message>
        <source>rms over trials</source>
        <translation>eff. über Versuche</translation>
    </message>
    <message>
        <source>rms relative error</source>
        <translation>mittlerer rel. Fehler</translation>
    </message>
    <message>
        <source>rms residual</source>
        <translation>mittlerer Rest</translation>
    </message>
    <message>
        <source>share slipped</source>
        <translation>gleitender Anteil</translation>
    </message>
    <message>
        <source>starts</source>
        <translation>Starts</translation>
    </message>
    <message>
        <source>std %</source>
        <translation>Streuung %</translation>
    </message>
    <message>
        <source>std error</source>
        <translation>Std.-Fehler</translation>
    </message>
    <message>
        <source>stiffness</source>
        <translation>Steifigkeit</translation>
    </message>
    <message>
        <source>stiffness lost</source>
        <translation>verlorene Steifigkeit</translation>
    </message>
    <message>
        <source>time ms</source>
        <translation>Zeit ms</translation>
    </message>
    <message>
        <source>times</source>
        <translation>Anzahl</translation>
    </message>
    <message>
        <source>to</source>
        <translation>nach</translation>
    </message>
    <message>
        <source>true value</source>
        <translation>wahrer Wert</translation>
    </message>
    <message>
        <source>unknown</source>
        <translation>Unbekannte</translation>
    </message>
    <message>
        <source>weighting</source>
        <translation>Gewichtung</translation>
    </message>
    <message>
        <source>worst bound</source>
        <translation>schlechteste Schranke</translation>
    </message>
    <message>
        <source>χ² alone</source>
        <translation>χ² allein</translation>
    </message>
</context>
<context>
    <name>SceneEditor</name>
    <message>
        <source>Scene</source>
        <translation>Szene</translation>
    </message>
    <message>
        <source>The scene as text (TOML). Ctrl+Space lists the valid words.</source>
        <translation>Die Szene als Text (TOML). Strg+Leertaste zeigt die gültigen Wörter.</translation>
    </message>
    <message>
        <source>Completions</source>
        <translation>Ergänzungen</translation>
    </message>
    <message>
        <source>Line numbers</source>
        <translation>Zeilennummern</translation>
    </message>
</context>
<context>
    <name>SceneForm</name>
    <message>
        <source>Scene as a form</source>
        <translation>Szene als Formular</translation>
    </message>
    <message>
        <source>Errors in these fields</source>
        <translation>Fehler in diesen Feldern</translation>
    </message>
    <message>
        <source>This is a separate table in the text.</source>
        <translation>Dies ist im Text eine eigene Tabelle.</translation>
    </message>
    <message>
        <source>File of these fields</source>
        <translation>Datei dieser Felder</translation>
    </message>
    <message>
        <source>file</source>
        <translation>Datei</translation>
    </message>
    <message>
        <source>Joint of these fields</source>
        <translation>Fügestelle dieser Felder</translation>
    </message>
    <message>
        <source>joint</source>
        <translation>Fügestelle</translation>
    </message>
    <message>
        <source>the only one</source>
        <translation>die einzige</translation>
    </message>
    <message>
        <source>The text has this file as one value.</source>
        <translation>Der Text hat diese Datei als einen Wert.</translation>
    </message>
    <message>
        <source>Table of these fields: %1</source>
        <translation>Tabelle dieser Felder: %1</translation>
    </message>
    <message>
        <source>table</source>
        <translation>Tabelle</translation>
    </message>
</context>
<context>
    <name>ScenePage</name>
    <message>
        <source>Status: %1</source>
        <translation>Status: %1</translation>
    </message>
    <message>
        <source>SCENE.toml</source>
        <translation>SZENE.toml</translation>
    </message>
    <message>
        <source>Task of the scene</source>
        <translation>Aufgabe der Szene</translation>
    </message>
    <message>
        <source>trials</source>
        <translation>Versuche</translation>
    </message>
</context>
<context>
    <name>SolvePage</name>
    <message>
        <source>Solve</source>
        <translation>Lösen</translation>
    </message>
    <message>
        <source>Plan</source>
        <translation>Plan</translation>
    </message>
    <message>
        <source>Cramér–Rao bounds</source>
        <translation>Cramér-Rao-Schranken</translation>
    </message>
    <message>
        <source>Unknowns</source>
        <translation>Unbekannte</translation>
    </message>
    <message>
        <source>Findings</source>
        <translation>Befunde</translation>
    </message>
    <message>
        <source>Comparison of runs</source>
        <translation>Vergleich der Läufe</translation>
    </message>
    <message>
        <source>Status of the solution</source>
        <translation>Status der Lösung</translation>
    </message>
    <message>
        <source>Plan and results</source>
        <translation>Plan und Ergebnisse</translation>
    </message>
    <message>
        <source>Bounds</source>
        <translation>Schranken</translation>
    </message>
    <message>
        <source>Joint</source>
        <translation>Fügestelle</translation>
    </message>
    <message>
        <source>Assembly FRFs</source>
        <translation>FRFs des Zusammenbaus</translation>
    </message>
    <message>
        <source>Runs</source>
        <translation>Läufe</translation>
    </message>
    <message>
        <source>Solving</source>
        <translation>Lösen</translation>
    </message>
    <message>
        <source>Identify the joint (F5)</source>
        <translation>Die Fügestelle identifizieren (F5)</translation>
    </message>
    <message>
        <source>The smallest standard errors that the data allow, and the effect of other data</source>
        <translation>Die kleinsten Standardfehler, die die Daten zulassen, und der Einfluss anderer Daten</translation>
    </message>
    <message>
        <source>Stop and keep the best values so far (Shift+F5)</source>
        <translation>Anhalten und die bisher besten Werte behalten (Umschalt+F5)</translation>
    </message>
    <message>
        <source>Copy as command</source>
        <translation>Als Befehl kopieren</translation>
    </message>
    <message>
        <source>Copy the command line with the same solution</source>
        <translation>Die Befehlszeile mit derselben Lösung kopieren</translation>
    </message>
    <message>
        <source>Table…</source>
        <translation>Tabelle …</translation>
    </message>
    <message>
        <source>Save the visible table as CSV</source>
        <translation>Die sichtbare Tabelle als CSV speichern</translation>
    </message>
    <message>
        <source>Report…</source>
        <translation>Bericht …</translation>
    </message>
    <message>
        <source>Save the page that `jointid solve --report` writes</source>
        <translation>Die Seite speichern, die `jointid solve --report` schreibt</translation>
    </message>
    <message>
        <source>JSON…</source>
        <translation>JSON …</translation>
    </message>
    <message>
        <source>Save the solution as `jointid solve --json` writes it</source>
        <translation>Die Lösung speichern, wie `jointid solve --json` sie schreibt</translation>
    </message>
    <message>
        <source>Planned. F5 solves.</source>
        <translation>Geplant. F5 löst.</translation>
    </message>
    <message>
        <source>Predicting bounds …</source>
        <translation>Schranken werden vorhergesagt …</translation>
    </message>
    <message>
        <source>Cancelled: some changes of the data are not predicted.</source>
        <translation>Abgebrochen: einige Änderungen der Daten sind nicht vorhergesagt.</translation>
    </message>
    <message>
        <source>Bounds are predicted.</source>
        <translation>Die Schranken sind vorhergesagt.</translation>
    </message>
    <message>
        <source>Solving …</source>
        <translation>Wird gelöst …</translation>
    </message>
    <message>
        <source>%1, %2, %3</source>
        <translation>%1, %2, %3</translation>
    </message>
    <message>
        <source>
assembly FRF error %1 dB</source>
        <translation>
FRF-Fehler des Zusammenbaus %1 dB</translation>
    </message>
    <message>
        <source>; %1 s</source>
        <translation>; %1 s</translation>
    </message>
    <message>
        <source>SCENE.toml</source>
        <translation>SZENE.toml</translation>
    </message>
    <message>
        <source>There is no solution yet.</source>
        <translation>Es gibt noch keine Lösung.</translation>
    </message>
    <message>
        <source>Save the solution</source>
        <translation>Die Lösung speichern</translation>
    </message>
    <message>
        <source>JSON (*.json)</source>
        <translation>JSON (*.json)</translation>
    </message>
    <message>
        <source>Save the report</source>
        <translation>Den Bericht speichern</translation>
    </message>
    <message>
        <source>Pages (*.html)</source>
        <translation>Seiten (*.html)</translation>
    </message>
    <message>
        <source>The report is written to %1.</source>
        <translation>Der Bericht ist nach %1 geschrieben.</translation>
    </message>
    <message>
        <source>No table is visible. The plot has its own button.</source>
        <translation>Keine Tabelle ist sichtbar. Das Diagramm hat seinen eigenen Knopf.</translation>
    </message>
    <message>
        <source>Save the table</source>
        <translation>Die Tabelle speichern</translation>
    </message>
    <message>
        <source>Tables (*.csv)</source>
        <translation>Tabellen (*.csv)</translation>
    </message>
    <message>
        <source>Springs: stiffness and loss factor</source>
        <translation>Federn: Steifigkeit und Verlustfaktor</translation>
    </message>
    <message>
        <source>Springs</source>
        <translation>Federn</translation>
    </message>
    <message>
        <source>The joint has %1 unknowns: few tests determine so many, and solving takes long. The joint assistant (Ctrl+J) makes springs of them. Solve again (F5) solves it as it is.</source>
        <translation>Die Fügestelle hat %1 Unbekannte: Wenige Versuche bestimmen so viele, und das Lösen dauert lange. Der Fügestellen-Assistent (Strg+J) macht Federn daraus. Nochmals Lösen (F5) löst sie, wie sie ist.</translation>
    </message>
    <message>
        <source>Differences</source>
        <translation>Unterschiede</translation>
    </message>
    <message>
        <source>Objective and unknowns over the iterations</source>
        <translation>Zielfunktion und Unbekannte über den Iterationen</translation>
    </message>
    <message>
        <source>A method that iterates shows its objective and its unknowns here, iteration by iteration.</source>
        <translation>Ein iterierendes Verfahren zeigt hier Zielfunktion und Unbekannte, Iteration für Iteration.</translation>
    </message>
    <message>
        <source>Iterations</source>
        <translation>Iterationen</translation>
    </message>
    <message>
        <source>Solutions of this scene, the newest last</source>
        <translation>Lösungen dieser Szene, die neueste zuletzt</translation>
    </message>
    <message>
        <source>The run is not kept: %1</source>
        <translation>Der Lauf wird nicht aufbewahrt: %1</translation>
    </message>
    <message>
        <source>The scene was another then: Run – Scene of this run.</source>
        <translation>Die Szene war damals eine andere: Lauf – Szene dieses Laufs.</translation>
    </message>
    <message>
        <source>Files that changed since this run: %1.</source>
        <translation>Seit diesem Lauf geänderte Dateien: %1.</translation>
    </message>
    <message>
        <source>unknowns</source>
        <translation>Unbekannte</translation>
    </message>
    <message>
        <source>The report needs the FRFs of this run, and they cannot be read.</source>
        <translation>Der Bericht braucht die FRFs dieses Laufs, und diese sind nicht lesbar.</translation>
    </message>
    <message>
        <source>The run in front</source>
        <translation>Der Lauf, der zu sehen ist</translation>
    </message>
    <message>
        <source>The scene of this run; remove it</source>
        <translation>Die Szene dieses Laufs; ihn entfernen</translation>
    </message>
    <message>
        <source>Run</source>
        <translation>Lauf</translation>
    </message>
    <message>
        <source>&amp;Scene of this run</source>
        <translation>&amp;Szene dieses Laufs</translation>
    </message>
    <message>
        <source>&amp;Remove this run…</source>
        <translation>Diesen Lauf &amp;entfernen…</translation>
    </message>
    <message>
        <source>Some kept runs cannot be read. %1</source>
        <translation>Einige aufbewahrte Läufe sind nicht lesbar. %1</translation>
    </message>
    <message>
        <source>The FRFs of this run are not drawn: %1</source>
        <translation>Die FRFs dieses Laufs werden nicht gezeichnet: %1</translation>
    </message>
    <message>
        <source>Remove a run</source>
        <translation>Einen Lauf entfernen</translation>
    </message>
    <message>
        <source>Remove run %1 and its file?</source>
        <translation>Lauf %1 und seine Datei entfernen?</translation>
    </message>
    <message>
        <source>%1 cannot be removed.</source>
        <translation>%1 lässt sich nicht entfernen.</translation>
    </message>
    <message>
        <source>There is no run.</source>
        <translation>Es gibt keinen Lauf.</translation>
    </message>
</context>
<context>
    <name>StructureView</name>
    <message>
        <source>Structure: nodes, lines and measured DOFs</source>
        <translation>Struktur: Knoten, Linien und gemessene DOFs</translation>
    </message>
    <message>
        <source>The files of the scene have no positions of nodes (UFF datasets 15 and 2411, node_position in HDF5).
You can choose joint DOFs in the list.</source>
        <translation>Die Dateien der Szene haben keine Positionen von Knoten (UFF-Datensätze 15 und 2411, node_position in HDF5).
DOFs der Fügestelle lassen sich in der Liste wählen.</translation>
    </message>
    <message>
        <source>at rest</source>
        <translation>in Ruhe</translation>
    </message>
    <message>
        <source>most</source>
        <translation>am meisten</translation>
    </message>
</context>
<context>
    <name>StudyPage</name>
    <message>
        <source>Study</source>
        <translation>Studie</translation>
    </message>
    <message>
        <source>Status of the study</source>
        <translation>Status der Studie</translation>
    </message>
    <message>
        <source>Histograms of the unknowns</source>
        <translation>Histogramme der Unbekannten</translation>
    </message>
    <message>
        <source>Run shows the estimates of all trials as histograms.
The noise is that of [noise], or that of the coherences of the files.</source>
        <translation>„Start“ zeigt die Schätzwerte aller Versuche als Histogramme.
Das Rauschen ist das von [noise], oder das der Kohärenzen der Dateien.</translation>
    </message>
    <message>
        <source>Statistics of the unknowns</source>
        <translation>Statistik der Unbekannten</translation>
    </message>
    <message>
        <source>Histograms and table</source>
        <translation>Histogramme und Tabelle</translation>
    </message>
    <message>
        <source>Cancelled: no trial was finished.</source>
        <translation>Abgebrochen: kein Versuch war fertig.</translation>
    </message>
    <message>
        <source>Studying</source>
        <translation>Studie</translation>
    </message>
    <message>
        <source>Run</source>
        <translation>Start</translation>
    </message>
    <message>
        <source>Identify repeatedly with simulated noise</source>
        <translation>Wiederholt mit simuliertem Rauschen identifizieren</translation>
    </message>
    <message>
        <source>Stop and keep the finished trials. The next run continues from there</source>
        <translation>Anhalten und die fertigen Versuche behalten. Der nächste Start macht dort weiter</translation>
    </message>
    <message>
        <source>trials</source>
        <translation>Versuche</translation>
    </message>
    <message>
        <source>seed</source>
        <translation>Startzahl</translation>
    </message>
    <message>
        <source>from the beginning</source>
        <translation>von vorn</translation>
    </message>
    <message>
        <source>Do not continue a cancelled run</source>
        <translation>Einen abgebrochenen Lauf nicht fortsetzen</translation>
    </message>
    <message>
        <source>Discard the trials of a cancelled run, as after a change of the scene</source>
        <translation>Die Versuche eines abgebrochenen Laufs verwerfen, wie nach einer Änderung der Szene</translation>
    </message>
    <message>
        <source>Which histograms</source>
        <translation>Welche Histogramme</translation>
    </message>
    <message>
        <source>Copy as command</source>
        <translation>Als Befehl kopieren</translation>
    </message>
    <message>
        <source>Copy the command line that writes the same file</source>
        <translation>Die Befehlszeile kopieren, die dieselbe Datei schreibt</translation>
    </message>
    <message>
        <source>Save the scene first. The results of the study are written beside it.</source>
        <translation>Speichern Sie zuerst die Szene. Die Ergebnisse der Studie werden daneben geschrieben.</translation>
    </message>
    <message>
        <source>Continuing …</source>
        <translation>Wird fortgesetzt …</translation>
    </message>
    <message>
        <source>Running …</source>
        <translation>Läuft …</translation>
    </message>
    <message>
        <source>
all results: %1</source>
        <translation>
alle Ergebnisse: %1</translation>
    </message>
    <message>
        <source>Cancelled: %1 of %2 trials are kept. Run continues from there.</source>
        <translation>Abgebrochen: %1 von %2 Versuchen sind behalten. Start macht dort weiter.</translation>
    </message>
    <message>
        <source>SCENE.toml</source>
        <translation>SZENE.toml</translation>
    </message>
</context>
<context>
    <name>TableMenu</name>
    <message>
        <source>Which table is shown</source>
        <translation>Welche Tabelle gezeigt wird</translation>
    </message>
</context>
<context>
    <name>ToolForm</name>
    <message>
        <source>all</source>
        <translation>alle</translation>
    </message>
    <message>
        <source>Choose: %1</source>
        <translation>Wählen: %1</translation>
    </message>
</context>
<context>
    <name>VariableDialog</name>
    <message>
        <source>Which variable holds the FRFs?</source>
        <translation>Welche Variable enthält die FRFs?</translation>
    </message>
    <message>
        <source>Several variables may be the FRFs. The choice becomes the key variable of [data.files] in the scene.</source>
        <translation>Mehrere Variablen könnten die FRFs sein. Die Wahl wird der Schlüssel variable von [data.files] in der Szene.</translation>
    </message>
    <message>
        <source>Variable of %1</source>
        <translation>Variable von %1</translation>
    </message>
    <message>
        <source>Open the files, or leave them</source>
        <translation>Die Dateien öffnen oder nicht</translation>
    </message>
</context>
<context>
    <name>WorthRow</name>
    <message>
        <source>What the result is worth</source>
        <translation>Was das Ergebnis taugt</translation>
    </message>
    <message>
        <source>determined</source>
        <translation>bestimmt</translation>
    </message>
    <message>
        <source>passive</source>
        <translation>passiv</translation>
    </message>
    <message>
        <source>within the noise</source>
        <translation>im Rauschen</translation>
    </message>
    <message>
        <source>better than no joint</source>
        <translation>besser als ohne Fügestelle</translation>
    </message>
</context>
</TS>
