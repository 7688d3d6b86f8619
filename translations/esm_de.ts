<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de_DE" sourcelanguage="en">
<context>
    <name>RuleDisplay</name>
    <message>
        <source>The word ‘%1’ is missing here.</source>
        <translation>Hier fehlt das Wort „%1“.</translation>
    </message>
    <message>
        <source>The word ‘%1’ is expected before ‘%2’.</source>
        <translation>Vor „%2“ wird das Wort „%1“ erwartet.</translation>
    </message>
    <message>
        <source>A rule begins with ‘%1’.</source>
        <translation>Eine Regel beginnt mit „%1“.</translation>
    </message>
    <message>
        <source>The name of a variable is missing here.</source>
        <translation>Hier fehlt der Name einer Größe.</translation>
    </message>
    <message>
        <source>‘%1’ stands where the name of a variable is expected.</source>
        <translation>Statt „%1“ wird hier der Name einer Größe erwartet.</translation>
    </message>
    <message>
        <source>A word that describes the variable is missing here.</source>
        <translation>Hier fehlt ein Wort, das die Größe beschreibt.</translation>
    </message>
    <message>
        <source>‘%1’ stands where a word for the variable is expected.</source>
        <translation>Statt „%1“ wird hier ein Wort für die Größe erwartet.</translation>
    </message>
    <message>
        <source>There is no variable named ‘%1’.</source>
        <translation>Eine Größe „%1“ gibt es nicht.</translation>
    </message>
    <message>
        <source>‘%1’ is not a word of this variable.</source>
        <translation>„%1“ ist kein Wort dieser Größe.</translation>
    </message>
    <message>
        <source>‘%1’ is a result and cannot stand in the condition.</source>
        <translation>„%1“ ist ein Ergebnis und kann nicht in der Bedingung stehen.</translation>
    </message>
    <message>
        <source>‘%1’ is an input and cannot stand in the conclusion.</source>
        <translation>„%1“ ist eine Eingabe und kann nicht in der Folgerung stehen.</translation>
    </message>
    <message>
        <source>A weight between 0 and 1 is expected here.</source>
        <translation>Hier wird ein Gewicht zwischen 0 und 1 erwartet.</translation>
    </message>
    <message>
        <source>A parenthesis lacks its partner.</source>
        <translation>Einer Klammer fehlt ihr Gegenstück.</translation>
    </message>
    <message>
        <source>‘%1’ does not belong here.</source>
        <translation>„%1“ gehört nicht hierher.</translation>
    </message>
    <message>
        <source>The text is empty.</source>
        <translation>Der Text ist leer.</translation>
    </message>
</context>
<context>
    <name>esm::CalibrateDialog</name>
    <message>
        <source>Calibrate</source>
        <translation>Kalibrieren</translation>
    </message>
    <message>
        <source>Force at 100 %, in newtons</source>
        <translation>Kraft bei 100 %, in Newton</translation>
    </message>
    <message>
        <source> N</source>
        <translation> N</translation>
    </message>
    <message>
        <source>Force at 100 %, as a spring scale shows it:</source>
        <translation>Kraft bei 100 %, wie eine Federwaage sie zeigt:</translation>
    </message>
    <message>
        <source>Pushes left instead of right</source>
        <translation>Drückt nach links statt nach rechts</translation>
    </message>
    <message>
        <source>Pushes towards you instead of away</source>
        <translation>Drückt zu dir hin statt von dir weg</translation>
    </message>
    <message>
        <source>The force is reversed:</source>
        <translation>Die Kraft ist verkehrt herum:</translation>
    </message>
    <message>
        <source>Zero of the scene in the device, X</source>
        <translation>Nullpunkt der Szene im Gerät, X</translation>
    </message>
    <message>
        <source>Zero of the scene in the device, Y</source>
        <translation>Nullpunkt der Szene im Gerät, Y</translation>
    </message>
    <message>
        <source>Zero of the scene in the device, Z</source>
        <translation>Nullpunkt der Szene im Gerät, Z</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>Where in the device the scene has its zero:</source>
        <translation>Wo im Gerät die Szene ihren Nullpunkt hat:</translation>
    </message>
    <message>
        <source>Holds from the next connection on.</source>
        <translation>Gilt ab der nächsten Verbindung.</translation>
    </message>
</context>
<context>
    <name>esm::ChangedFilesBar</name>
    <message>
        <source>Updated: %1 nodes as before, %2 new, %3 gone</source>
        <translation>Aktualisiert: %1 Knoten wie zuvor, %2 neu, %3 fort</translation>
    </message>
    <message>
        <source>update the model</source>
        <translation>Modell aktualisieren</translation>
    </message>
    <message>
        <source>The model is being updated …</source>
        <translation>Das Modell wird aktualisiert …</translation>
    </message>
    <message numerus="yes">
        <source>%n file(s) of the model changed since the import: %1</source>
        <translation>
            <numerusform>%n Datei des Modells wurde seit dem Import geändert: %1</numerusform>
            <numerusform>%n Dateien des Modells wurden seit dem Import geändert: %1</numerusform>
        </translation>
    </message>
    <message>
        <source>Update</source>
        <translation>Aktualisieren</translation>
    </message>
    <message>
        <source>Import again with the same choices; what can be is carried over</source>
        <translation>Mit denselben Einstellungen neu importieren; was geht, wird übernommen</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Ignore</source>
        <translation>Ignorieren</translation>
    </message>
    <message>
        <source>Changed files</source>
        <translation>Geänderte Dateien</translation>
    </message>
</context>
<context>
    <name>esm::Commands</name>
    <message>
        <source>rename</source>
        <translation>umbenennen</translation>
    </message>
    <message>
        <source>hold nodes</source>
        <translation>Knoten festhalten</translation>
    </message>
    <message>
        <source>free nodes</source>
        <translation>Knoten freigeben</translation>
    </message>
    <message>
        <source>change gravity</source>
        <translation>Schwerkraft ändern</translation>
    </message>
    <message>
        <source>choose solver</source>
        <translation>Löser wählen</translation>
    </message>
    <message>
        <source>take parameters from tissue</source>
        <translation>Parameter aus dem Gewebe nehmen</translation>
    </message>
    <message>
        <source>keep parameters as they are</source>
        <translation>Parameter lassen, wie sie sind</translation>
    </message>
    <message>
        <source>change input</source>
        <translation>Eingabe ändern</translation>
    </message>
    <message>
        <source>change tissue</source>
        <translation>Gewebe ändern</translation>
    </message>
</context>
<context>
    <name>esm::DefectList</name>
    <message>
        <source>Defects of the mesh</source>
        <translation>Fehler der Datei</translation>
    </message>
    <message>
        <source>No defect found</source>
        <translation>Kein Fehler gefunden</translation>
    </message>
    <message>
        <source>... and %1 more</source>
        <translation>... und %1 weitere</translation>
    </message>
    <message>
        <source>Open borders: %1</source>
        <translation>Offene Ränder: %1</translation>
    </message>
    <message>
        <source>Edges of more than two triangles: %1</source>
        <translation>Kanten mit mehr als zwei Dreiecken: %1</translation>
    </message>
    <message>
        <source>Vertices where surfaces touch: %1</source>
        <translation>Eckpunkte, an denen sich Flächen berühren: %1</translation>
    </message>
    <message>
        <source>Vertices on the edge of another triangle: %1</source>
        <translation>Eckpunkte auf der Kante eines anderen Dreiecks: %1</translation>
    </message>
    <message>
        <source>Degenerate triangles: %1</source>
        <translation>Entartete Dreiecke: %1</translation>
    </message>
    <message>
        <source>Duplicate triangles: %1</source>
        <translation>Doppelte Dreiecke: %1</translation>
    </message>
    <message>
        <source>Triangles turned inside out: %1</source>
        <translation>Umgedrehte Dreiecke: %1</translation>
    </message>
    <message>
        <source>Edges over which sides cannot agree: %1</source>
        <translation>Kanten, über die keine einheitliche Seite geht: %1</translation>
    </message>
    <message>
        <source>Vertices that nothing uses: %1</source>
        <translation>Unbenutzte Eckpunkte: %1</translation>
    </message>
    <message>
        <source>Separate parts beside the largest: %1</source>
        <translation>Einzelne Teile neben dem größten: %1</translation>
    </message>
    <message numerus="yes">
        <source>Border of %n edge(s), %1 mm long</source>
        <translation>
            <numerusform>Rand aus %n Kante, %1 mm lang</numerusform>
            <numerusform>Rand aus %n Kanten, %1 mm lang</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Part of %n element(s)</source>
        <translation>
            <numerusform>Teil aus %n Element</numerusform>
            <numerusform>Teil aus %n Elementen</numerusform>
        </translation>
    </message>
    <message>
        <source>No. %1 at %2, %3, %4 mm</source>
        <translation>Nr. %1 bei %2, %3, %4 mm</translation>
    </message>
    <message>
        <source>Triangles that run through others: %1</source>
        <translation>Dreiecke, die andere durchdringen: %1</translation>
    </message>
    <message>
        <source>at least %1</source>
        <translation>mindestens %1</translation>
    </message>
    <message>
        <source>The search ended early: there may be more</source>
        <translation>Die Suche endete vorzeitig: es kann mehr geben</translation>
    </message>
    <message>
        <source>“esm inspect --defects --intersections” looks at all triangles</source>
        <translation>„esm inspect --defects --intersections“ sieht alle Dreiecke an</translation>
    </message>
</context>
<context>
    <name>esm::Document</name>
    <message>
        <source>Untitled</source>
        <translation>Ohne Titel</translation>
    </message>
    <message>
        <source>Base tissue</source>
        <translation>Grundgewebe</translation>
    </message>
    <message>
        <source>import %1</source>
        <translation>%1 importieren</translation>
    </message>
    <message>
        <source>add %1</source>
        <translation>%1 hinzufügen</translation>
    </message>
    <message>
        <source>add region</source>
        <translation>Region hinzufügen</translation>
    </message>
    <message>
        <source>remove region</source>
        <translation>Region entfernen</translation>
    </message>
    <message>
        <source>reorder regions</source>
        <translation>Regionen umordnen</translation>
    </message>
    <message>
        <source>lock region</source>
        <translation>Region sperren</translation>
    </message>
    <message>
        <source>unlock region</source>
        <translation>Region entsperren</translation>
    </message>
    <message>
        <source>show region</source>
        <translation>Region zeigen</translation>
    </message>
    <message>
        <source>hide region</source>
        <translation>Region verbergen</translation>
    </message>
    <message>
        <source>make the twin a region of its own</source>
        <translation>Zwilling zu eigener Region machen</translation>
    </message>
</context>
<context>
    <name>esm::EmulatorPanel</name>
    <message>
        <source>The Falcon of this list is emulated: driver and force loop are real, the device is not. Any file will do as its firmware; with the tool Pull the mouse leads its grip.</source>
        <translation>Der Falcon dieser Liste ist emuliert: Treiber und Kraftschleife sind echt, das Gerät nicht. Als Firmware taugt jede Datei; mit dem Werkzeug „Ziehen“ führt die Maus den Griff.</translation>
    </message>
    <message>
        <source>Plugged in</source>
        <translation>Angesteckt</translation>
    </message>
    <message>
        <source>Permitted</source>
        <translation>Berechtigt</translation>
    </message>
    <message>
        <source>Loose contact</source>
        <translation>Wackelkontakt</translation>
    </message>
    <message>
        <source>Pull the grip out and push it in</source>
        <translation>Griff herausziehen und hineinschieben</translation>
    </message>
</context>
<context>
    <name>esm::ErrorDetail</name>
    <message>
        <source>No such file or directory</source>
        <translation>Datei oder Verzeichnis gibt es nicht</translation>
    </message>
    <message>
        <source>Permission denied</source>
        <translation>keine Berechtigung</translation>
    </message>
    <message>
        <source>Operation not permitted</source>
        <translation>nicht erlaubt</translation>
    </message>
    <message>
        <source>No space left on device</source>
        <translation>kein Platz mehr auf dem Datenträger</translation>
    </message>
    <message>
        <source>Disk quota exceeded</source>
        <translation>Speicherkontingent erschöpft</translation>
    </message>
    <message>
        <source>Read-only file system</source>
        <translation>Dateisystem nur lesbar</translation>
    </message>
    <message>
        <source>Is a directory</source>
        <translation>ist ein Verzeichnis</translation>
    </message>
    <message>
        <source>Not a directory</source>
        <translation>kein Verzeichnis</translation>
    </message>
    <message>
        <source>File too large</source>
        <translation>Datei zu groß</translation>
    </message>
    <message>
        <source>File name too long</source>
        <translation>Dateiname zu lang</translation>
    </message>
    <message>
        <source>Too many open files</source>
        <translation>zu viele offene Dateien</translation>
    </message>
    <message>
        <source>Too many levels of symbolic links</source>
        <translation>zu viele Verweise hintereinander</translation>
    </message>
    <message>
        <source>Input/output error</source>
        <translation>Ein-/Ausgabefehler</translation>
    </message>
    <message>
        <source>Cannot allocate memory</source>
        <translation>kein Speicher mehr</translation>
    </message>
    <message>
        <source>is a folder, not a file</source>
        <translation>ist ein Ordner, keine Datei</translation>
    </message>
    <message>
        <source>is %1, not a file</source>
        <translation>ist %1, keine Datei</translation>
    </message>
    <message>
        <source>a device</source>
        <translation>ein Gerät</translation>
    </message>
    <message>
        <source>a pipe</source>
        <translation>eine Pipe</translation>
    </message>
    <message>
        <source>a socket</source>
        <translation>ein Socket</translation>
    </message>
    <message>
        <source>cannot be read</source>
        <translation>nicht lesbar</translation>
    </message>
    <message>
        <source>cannot be read (%1)</source>
        <translation>nicht lesbar (%1)</translation>
    </message>
    <message>
        <source>cannot be written (%1)</source>
        <translation>nicht schreibbar (%1)</translation>
    </message>
    <message>
        <source>cannot be written, it is a folder</source>
        <translation>nicht schreibbar: das ist ein Ordner</translation>
    </message>
    <message>
        <source>cannot be written, it is %1</source>
        <translation>nicht schreibbar: das ist %1</translation>
    </message>
    <message>
        <source>name a file</source>
        <translation>eine Datei angeben</translation>
    </message>
    <message>
        <source>save it under another name</source>
        <translation>bitte unter anderem Namen speichern</translation>
    </message>
    <message>
        <source>is in the way, a folder of this name is needed</source>
        <translation>steht im Weg: ein Ordner dieses Namens wird gebraucht</translation>
    </message>
    <message>
        <source>would be replaced, but holds %1</source>
        <translation>würde ersetzt, enthält aber %1</translation>
    </message>
    <message>
        <source>move it away</source>
        <translation>es beiseitelegen</translation>
    </message>
    <message>
        <source>cannot be written in this format</source>
        <translation>in diesem Format nicht schreibbar</translation>
    </message>
    <message>
        <source>the ending must be one of %1</source>
        <translation>die Endung muss eine von diesen sein: %1</translation>
    </message>
    <message>
        <source>not written, the net has no triangles and STL holds nothing else</source>
        <translation>nicht geschrieben: das Netz hat keine Dreiecke, und STL fasst nichts anderes</translation>
    </message>
    <message>
        <source>use obj or ply</source>
        <translation>OBJ oder PLY nehmen</translation>
    </message>
    <message>
        <source>not written, %1 is not finite</source>
        <translation>nicht geschrieben: %1 ist nicht endlich</translation>
    </message>
    <message>
        <source>not written, %1</source>
        <translation>nicht geschrieben: %1</translation>
    </message>
    <message>
        <source>the motion of node %1</source>
        <translation>die Bewegung von Knoten %1</translation>
    </message>
    <message>
        <source>a spring&apos;s force</source>
        <translation>die Kraft einer Feder</translation>
    </message>
    <message>
        <source>the net is empty</source>
        <translation>das Netz ist leer</translation>
    </message>
    <message>
        <source>line %1</source>
        <translation>Zeile %1</translation>
    </message>
    <message>
        <source>the document</source>
        <translation>das Dokument</translation>
    </message>
    <message>
        <source>parse error at line %1, column %2</source>
        <translation>unverständlich in Zeile %1, Spalte %2</translation>
    </message>
    <message>
        <source>syntax error while parsing %1</source>
        <translation>Schreibfehler (%1)</translation>
    </message>
    <message>
        <source>an object has more than 1000 keys</source>
        <translation>ein Objekt hat mehr als 1000 Schlüssel</translation>
    </message>
    <message>
        <source>nested deeper than 32 levels</source>
        <translation>tiefer als 32 Ebenen verschachtelt</translation>
    </message>
    <message>
        <source>is empty, it holds no project</source>
        <translation>ist leer und enthält kein Projekt</translation>
    </message>
    <message>
        <source>is neither a project (.esm, .esmb) nor a net in the esm-net-1 or Xsp format</source>
        <translation>ist weder ein Projekt (.esm, .esmb) noch ein Netz im Format esm-net-1 oder Xsp</translation>
    </message>
    <message>
        <source>%1 was written by a newer version of this program (schema version %2, this program knows %3)</source>
        <translation>%1 stammt von einer neueren Version dieses Programms (Schema %2, dieses Programm kennt %3)</translation>
    </message>
    <message>
        <source>open it with that version</source>
        <translation>mit jener Version öffnen</translation>
    </message>
    <message>
        <source>%1 does not hold together</source>
        <translation>%1 passt nicht zusammen</translation>
    </message>
    <message>
        <source>%1 is missing, it must be %2</source>
        <translation>%1 fehlt; es muss %2 sein</translation>
    </message>
    <message>
        <source>%1 is %2, it must be %3</source>
        <translation>%1 ist %2, muss aber %3 sein</translation>
    </message>
    <message>
        <source>%1 has the unknown key %2</source>
        <translation>%1 hat den unbekannten Schlüssel %2</translation>
    </message>
    <message>
        <source>%1 lacks %2, an input of the rule base</source>
        <translation>%1 fehlt %2, eine Eingabe der Regelbasis</translation>
    </message>
    <message>
        <source>%1 lacks %2</source>
        <translation>in %1 fehlt %2</translation>
    </message>
    <message>
        <source>%1 is no input of the rule base</source>
        <translation>%1 ist keine Eingabe der Regelbasis</translation>
    </message>
    <message>
        <source>%1 is not valid UTF-8 text</source>
        <translation>%1 ist kein gültiger UTF-8-Text</translation>
    </message>
    <message>
        <source>an object</source>
        <translation>ein Objekt</translation>
    </message>
    <message>
        <source>a list</source>
        <translation>eine Liste</translation>
    </message>
    <message>
        <source>an empty list</source>
        <translation>eine leere Liste</translation>
    </message>
    <message>
        <source>a number</source>
        <translation>eine Zahl</translation>
    </message>
    <message>
        <source>a text</source>
        <translation>ein Text</translation>
    </message>
    <message>
        <source>true or false</source>
        <translation>true oder false</translation>
    </message>
    <message>
        <source>one of %1</source>
        <translation>eines von %1</translation>
    </message>
    <message>
        <source>an integer from %1 to %2</source>
        <translation>eine ganze Zahl von %1 bis %2</translation>
    </message>
    <message>
        <source>a number or a list of %1</source>
        <translation>eine Zahl oder eine Liste von %1</translation>
    </message>
    <message>
        <source>a word or a list of %1</source>
        <translation>ein Wort oder eine Liste von %1</translation>
    </message>
    <message>
        <source>absent, there is nothing to refer to</source>
        <translation>weggelassen, denn es gibt nichts, worauf es sich bezöge</translation>
    </message>
    <message>
        <source>a list of x, y, z triples, flat, so its length a multiple of 3</source>
        <translation>eine flache Liste von Tripeln x, y, z, ihre Länge also ein Vielfaches von 3</translation>
    </message>
    <message>
        <source>a flat list of %1 x, y, z triples</source>
        <translation>eine flache Liste von %1 Tripeln x, y, z</translation>
    </message>
    <message>
        <source>a list of three numbers</source>
        <translation>eine Liste von drei Zahlen</translation>
    </message>
    <message>
        <source>a list of three nodes</source>
        <translation>eine Liste von drei Knoten</translation>
    </message>
    <message>
        <source>a list of %1 numbers</source>
        <translation>eine Liste von %1 Zahlen</translation>
    </message>
    <message>
        <source>a flat list with a multiple of %1 node numbers</source>
        <translation>eine flache Liste von Knotennummern, ihre Länge ein Vielfaches von %1</translation>
    </message>
    <message>
        <source>another node than the spring&apos;s i</source>
        <translation>ein anderer Knoten als das i der Feder</translation>
    </message>
    <message>
        <source>%1 acts on a node that the net does not have</source>
        <translation>%1 wirkt auf einen Knoten, den das Netz nicht hat</translation>
    </message>
    <message>
        <source>%1 has not one value for each of its times, at least one</source>
        <translation>%1 hat nicht zu jeder Zeit einen Wert, mindestens einen</translation>
    </message>
    <message>
        <source>%1 has times that go back</source>
        <translation>%1 hat Zeiten, die zurückgehen</translation>
    </message>
    <message>
        <source>the solver %1 is unknown</source>
        <translation>der Löser %1 ist unbekannt</translation>
    </message>
    <message>
        <source>the tissue or a region has not one input for each of the rule base</source>
        <translation>dem Gewebe oder einer Region fehlt eine Eingabe der Regelbasis</translation>
    </message>
    <message>
        <source>%1 is not a finite number</source>
        <translation>%1 ist keine endliche Zahl</translation>
    </message>
    <message>
        <source>the net of this project did not come from mesh files</source>
        <translation>das Netz dieses Projekts kam nicht aus Netzdateien</translation>
    </message>
    <message>
        <source>there is no spring in it</source>
        <translation>es ist keine Feder darin</translation>
    </message>
    <message>
        <source>does not begin with %1</source>
        <translation>beginnt nicht mit %1</translation>
    </message>
    <message>
        <source>spring %1 (id %2)</source>
        <translation>Feder %1 (Kennung %2)</translation>
    </message>
    <message>
        <source>node %1 (id %2)</source>
        <translation>Knoten %1 (Kennung %2)</translation>
    </message>
    <message>
        <source>its ends are nodes %1 and %2, they must be below %3</source>
        <translation>ihre Enden sind die Knoten %1 und %2, sie müssen unter %3 liegen</translation>
    </message>
    <message>
        <source>both ends are node %1</source>
        <translation>beide Enden sind der Knoten %1</translation>
    </message>
    <message>
        <source>stiffness</source>
        <translation>die Steifigkeit</translation>
    </message>
    <message>
        <source>rest length</source>
        <translation>die Ruhelänge</translation>
    </message>
    <message>
        <source>mass</source>
        <translation>die Masse</translation>
    </message>
    <message>
        <source>viscosity</source>
        <translation>die Viskosität</translation>
    </message>
    <message>
        <source>position</source>
        <translation>der Ort</translation>
    </message>
    <message>
        <source>triangle %1</source>
        <translation>Dreieck %1</translation>
    </message>
    <message>
        <source>it uses node %1, the net has %2 nodes</source>
        <translation>es benutzt den Knoten %1, das Netz hat %2 Knoten</translation>
    </message>
    <message>
        <source>%1 has %2 inputs, the rule base asks for %3</source>
        <translation>%1 hat %2 Eingaben, die Regelbasis verlangt %3</translation>
    </message>
    <message>
        <source>the base tissue</source>
        <translation>das Grundgewebe</translation>
    </message>
    <message>
        <source>every semi-axis must be above 0 m</source>
        <translation>jede Halbachse muss über 0 m liegen</translation>
    </message>
    <message>
        <source>the centre is not finite</source>
        <translation>die Mitte ist nicht endlich</translation>
    </message>
    <message>
        <source>the rotation is not a unit quaternion</source>
        <translation>die Drehung ist kein Einheitsquaternion</translation>
    </message>
    <message>
        <source>the falloff must lie in 0 to 1</source>
        <translation>der Abfall muss in 0 bis 1 liegen</translation>
    </message>
    <message>
        <source>the rule base has no output %1</source>
        <translation>die Regelbasis hat keine Ausgabe %1</translation>
    </message>
    <message>
        <source>the range of output %1 must not go below 0</source>
        <translation>der Bereich der Ausgabe %1 darf nicht unter 0 gehen</translation>
    </message>
    <message>
        <source>the range of output &apos;density&apos; must lie above 0 kg/m^3</source>
        <translation>der Bereich der Ausgabe „density“ muss über 0 kg/m³ liegen</translation>
    </message>
    <message>
        <source>the wall&apos;s thickness must be above 0 m</source>
        <translation>die Wandstärke muss über 0 m liegen</translation>
    </message>
    <message>
        <source>the density must be above 0 kg/m^3</source>
        <translation>die Dichte muss über 0 kg/m³ liegen</translation>
    </message>
    <message>
        <source>region %1 &apos;%2&apos; is locked</source>
        <translation>Region %1 „%2“ ist gesperrt</translation>
    </message>
    <message>
        <source>unlock it first</source>
        <translation>sie zuerst entsperren</translation>
    </message>
    <message>
        <source>the surface has triangles but no area, so that its tissue has no mass</source>
        <translation>die Oberfläche hat Dreiecke, aber keine Fläche, ihr Gewebe also keine Masse</translation>
    </message>
    <message>
        <source>import the mesh with a smaller weld tolerance or the right unit</source>
        <translation>das Netz mit kleinerer Verschmelz-Toleranz oder der richtigen Einheit importieren</translation>
    </message>
    <message>
        <source>the mesh has no edge or line of positive length, so no spring</source>
        <translation>das Netz hat keine Kante oder Linie positiver Länge, also keine Feder</translation>
    </message>
    <message>
        <source>no ellipsoid can be fitted</source>
        <translation>kein Ellipsoid lässt sich anpassen</translation>
    </message>
    <message>
        <source>nothing is selected</source>
        <translation>nichts ist ausgewählt</translation>
    </message>
    <message>
        <source>the file is empty (0 bytes)</source>
        <translation>die Datei ist leer (0 Byte)</translation>
    </message>
    <message>
        <source>the file holds nothing but blanks (%1 bytes)</source>
        <translation>die Datei enthält nur Leerzeichen (%1 Byte)</translation>
    </message>
    <message>
        <source>this is %1, not a mesh that can be read</source>
        <translation>das ist %1, kein lesbares Netz</translation>
    </message>
    <message>
        <source>choose an OBJ, STL, PLY, OFF, DXF, VTK, Gmsh, glTF or other mesh file</source>
        <translation>eine Netzdatei wählen: OBJ, STL, PLY, OFF, DXF, VTK, Gmsh, glTF oder eine andere</translation>
    </message>
    <message>
        <source>binary data of an unknown kind</source>
        <translation>eine Binärdatei unbekannter Art</translation>
    </message>
    <message>
        <source>text of an unknown kind</source>
        <translation>ein Text unbekannter Art</translation>
    </message>
    <message>
        <source>JSON text</source>
        <translation>JSON-Text</translation>
    </message>
    <message>
        <source>XML text</source>
        <translation>XML-Text</translation>
    </message>
    <message>
        <source>no face or line in it has two corners apart from each other, so no spring comes out</source>
        <translation>keine Fläche oder Linie darin hat zwei getrennte Ecken, also entsteht keine Feder</translation>
    </message>
    <message>
        <source>there is not enough memory to read it</source>
        <translation>der Speicher reicht nicht, um sie zu lesen</translation>
    </message>
    <message>
        <source>with %1 bytes it is larger than the memory of this machine</source>
        <translation>mit %1 Byte ist sie größer als der Speicher dieses Rechners</translation>
    </message>
    <message>
        <source>simplify the mesh first</source>
        <translation>das Netz zuerst vereinfachen</translation>
    </message>
    <message>
        <source>simplify it first</source>
        <translation>es zuerst vereinfachen</translation>
    </message>
    <message>
        <source>the mesh has more vertices and corners than this program can count (%1)</source>
        <translation>das Netz hat mehr Ecken, als dieses Programm zählen kann (%1)</translation>
    </message>
    <message>
        <source>vertex %1 has a coordinate that is not a finite number (NaN or infinite), and a face or line uses it</source>
        <translation>Ecke %1 hat eine Koordinate, die keine endliche Zahl ist (NaN oder unendlich), und eine Fläche oder Linie benutzt sie</translation>
    </message>
    <message>
        <source>facet %1 has a coordinate that is not a finite number (NaN or infinite)</source>
        <translation>Facette %1 hat eine Koordinate, die keine endliche Zahl ist (NaN oder unendlich)</translation>
    </message>
    <message>
        <source>mend the file in the program that wrote it</source>
        <translation>die Datei in dem Programm richten, das sie schrieb</translation>
    </message>
    <message>
        <source>it is cut short</source>
        <translation>sie ist abgeschnitten</translation>
    </message>
    <message>
        <source>it is cut short, fetch it again</source>
        <translation>sie ist abgeschnitten, neu holen</translation>
    </message>
    <message>
        <source>is it cut short?</source>
        <translation>ist sie abgeschnitten?</translation>
    </message>
    <message>
        <source>is the file cut short?</source>
        <translation>ist die Datei abgeschnitten?</translation>
    </message>
    <message>
        <source>is the file damaged?</source>
        <translation>ist die Datei beschädigt?</translation>
    </message>
    <message>
        <source>the file is damaged</source>
        <translation>die Datei ist beschädigt</translation>
    </message>
    <message>
        <source>the file is cut short</source>
        <translation>die Datei ist abgeschnitten</translation>
    </message>
    <message>
        <source>is the file cut short or damaged?</source>
        <translation>ist die Datei abgeschnitten oder beschädigt?</translation>
    </message>
    <message>
        <source>convert it</source>
        <translation>umwandeln</translation>
    </message>
    <message>
        <source>save it as OBJ or PLY</source>
        <translation>als OBJ oder PLY speichern</translation>
    </message>
    <message>
        <source>there is no vertex %1, the file has %2 of them up to here</source>
        <translation>es gibt keine Ecke %1, bis hierher hat die Datei %2 davon</translation>
    </message>
    <message>
        <source>there is no vertex %1, the file has vertices 0 to %2</source>
        <translation>es gibt keine Ecke %1, die Datei hat die Ecken 0 bis %2</translation>
    </message>
    <message>
        <source>there is no point %1, the file has points 0 to %2</source>
        <translation>es gibt keinen Punkt %1, die Datei hat die Punkte 0 bis %2</translation>
    </message>
    <message>
        <source>it promises %1, but the file is too small for them</source>
        <translation>sie verspricht %1, aber dafür ist die Datei zu klein</translation>
    </message>
    <message>
        <source>a vertex needs three coordinates</source>
        <translation>eine Ecke braucht drei Koordinaten</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is no coordinate (numbers are written with a point)</source>
        <translation>„%1“ ist keine Koordinate (Zahlen stehen mit Punkt)</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is no corner (as 7, 7/1, 7//3 or 7/1/3)</source>
        <translation>„%1“ ist keine Ecke (wie 7, 7/1, 7//3 oder 7/1/3)</translation>
    </message>
    <message>
        <source>the file ends in the middle of a statement</source>
        <translation>die Datei endet mitten in einer Anweisung</translation>
    </message>
    <message>
        <source>it has %1 bytes, less than the 84 of a binary STL header</source>
        <translation>sie hat %1 Byte, weniger als die 84 am Anfang eines binären STL</translation>
    </message>
    <message>
        <source>its header promises %1 facets in %2 bytes, but it has %3</source>
        <translation>ihr Anfang verspricht %1 Facetten in %2 Byte, sie hat aber %3</translation>
    </message>
    <message>
        <source>it is cut short or no STL, fetch it again</source>
        <translation>sie ist abgeschnitten oder kein STL, neu holen</translation>
    </message>
    <message>
        <source>the file ends without &apos;endsolid&apos;</source>
        <translation>die Datei endet ohne „endsolid“</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is no word of an ASCII STL</source>
        <translation>„%1“ ist kein Wort eines ASCII-STL</translation>
    </message>
    <message>
        <source>a vertex needs three coordinates, written with a point</source>
        <translation>eine Ecke braucht drei Koordinaten, mit Punkt geschrieben</translation>
    </message>
    <message>
        <source>a vertex needs three coordinates, written with a point, not &apos;%1&apos;</source>
        <translation>eine Ecke braucht drei Koordinaten, mit Punkt geschrieben, nicht „%1“</translation>
    </message>
    <message>
        <source>a facet has %1 vertices, it needs three</source>
        <translation>eine Facette hat %1 Ecken, sie braucht drei</translation>
    </message>
    <message>
        <source>it is an STL without a single facet</source>
        <translation>das ist ein STL ohne eine einzige Facette</translation>
    </message>
    <message>
        <source>the header has no &apos;end_header&apos;</source>
        <translation>dem Anfang fehlt „end_header“</translation>
    </message>
    <message>
        <source>a PLY header line begins with &apos;%1&apos;</source>
        <translation>eine Zeile des PLY-Anfangs beginnt mit „%1“</translation>
    </message>
    <message>
        <source>the PLY format must be ascii, binary_little_endian or binary_big_endian</source>
        <translation>das PLY-Format muss ascii, binary_little_endian oder binary_big_endian sein</translation>
    </message>
    <message>
        <source>the PLY header has no &apos;format&apos; line</source>
        <translation>dem PLY-Anfang fehlt die Zeile „format“</translation>
    </message>
    <message>
        <source>its header promises %1 of &apos;%2&apos;, but the file is too small for them (%3 bytes)</source>
        <translation>ihr Anfang verspricht %1 mal „%2“, aber dafür ist die Datei zu klein (%3 Byte)</translation>
    </message>
    <message>
        <source>it holds %1 vertices but no face and no edge</source>
        <translation>sie enthält %1 Ecken, aber keine Fläche und keine Kante</translation>
    </message>
    <message>
        <source>its vertices have no x, y and z</source>
        <translation>ihre Ecken haben kein x, y und z</translation>
    </message>
    <message>
        <source>its faces have no list vertex_indices</source>
        <translation>ihren Flächen fehlt die Liste vertex_indices</translation>
    </message>
    <message>
        <source>vertex %1</source>
        <translation>Ecke %1</translation>
    </message>
    <message>
        <source>face %1</source>
        <translation>Fläche %1</translation>
    </message>
    <message>
        <source>edge %1</source>
        <translation>Kante %1</translation>
    </message>
    <message>
        <source>it holds %1 vertices but no face</source>
        <translation>sie enthält %1 Ecken, aber keine Fläche</translation>
    </message>
    <message>
        <source>binary OFF is not read</source>
        <translation>binäres OFF wird nicht gelesen</translation>
    </message>
    <message>
        <source>save it as text or as PLY</source>
        <translation>als Text oder PLY speichern</translation>
    </message>
    <message>
        <source>an OFF file begins with the counts of vertices and faces</source>
        <translation>eine OFF-Datei beginnt mit den Anzahlen von Ecken und Flächen</translation>
    </message>
    <message>
        <source>the counts promise more than the file has room for</source>
        <translation>die Anzahlen versprechen mehr, als die Datei fasst</translation>
    </message>
    <message>
        <source>a face begins with the number of its corners</source>
        <translation>eine Fläche beginnt mit der Anzahl ihrer Ecken</translation>
    </message>
    <message>
        <source>a face has fewer corners than it says</source>
        <translation>eine Fläche hat weniger Ecken, als sie sagt</translation>
    </message>
    <message>
        <source>it holds no line, polyline or face</source>
        <translation>sie enthält keine Linie, Polylinie oder Fläche</translation>
    </message>
    <message>
        <source>here a DXF group should begin with its number</source>
        <translation>hier sollte eine DXF-Gruppe mit ihrer Nummer beginnen</translation>
    </message>
    <message>
        <source>it ends without EOF</source>
        <translation>sie endet ohne EOF</translation>
    </message>
    <message>
        <source>binary DXF is not read</source>
        <translation>binäres DXF wird nicht gelesen</translation>
    </message>
    <message>
        <source>save it as DXF in text (ASCII)</source>
        <translation>als DXF in Text (ASCII) speichern</translation>
    </message>
    <message>
        <source>a VTK data set &apos;%1&apos; is no mesh of cells</source>
        <translation>ein VTK-Datensatz „%1“ ist kein Netz aus Zellen</translation>
    </message>
    <message>
        <source>extract its surface and save that as POLYDATA</source>
        <translation>die Oberfläche herausziehen und als POLYDATA speichern</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is no part of a VTK mesh</source>
        <translation>„%1“ ist kein Teil eines VTK-Netzes</translation>
    </message>
    <message>
        <source>cells of the VTK type %1 are not read</source>
        <translation>Zellen des VTK-Typs %1 werden nicht gelesen</translation>
    </message>
    <message>
        <source>triangulate them first</source>
        <translation>sie zuerst in Dreiecke zerlegen</translation>
    </message>
    <message>
        <source>it has no &lt;/VTKFile&gt; at its end</source>
        <translation>ihr fehlt &lt;/VTKFile&gt; am Ende</translation>
    </message>
    <message>
        <source>it holds %1 points but no line, face or tetrahedron</source>
        <translation>sie enthält %1 Punkte, aber keine Linie, Fläche und kein Tetraeder</translation>
    </message>
    <message>
        <source>this version of the Gmsh format is not read</source>
        <translation>diese Version des Gmsh-Formats wird nicht gelesen</translation>
    </message>
    <message>
        <source>save it in format 4.1 or 2.2</source>
        <translation>im Format 4.1 oder 2.2 speichern</translation>
    </message>
    <message>
        <source>elements of type %1 are not read</source>
        <translation>Elemente vom Typ %1 werden nicht gelesen</translation>
    </message>
    <message>
        <source>save the mesh with simpler ones</source>
        <translation>das Netz mit einfacheren speichern</translation>
    </message>
    <message>
        <source>there is no node %1, but an element uses it</source>
        <translation>es gibt keinen Knoten %1, aber ein Element benutzt ihn</translation>
    </message>
    <message>
        <source>this build was made without the Coin library, which reads Inventor and VRML</source>
        <translation>dieses Programm wurde ohne die Coin-Bibliothek gebaut, die Inventor und VRML liest</translation>
    </message>
    <message>
        <source>it is larger than 1 GB, which only OBJ, STL, PLY and OFF may be</source>
        <translation>sie ist größer als 1 GB, was nur OBJ, STL, PLY und OFF sein dürfen</translation>
    </message>
    <message>
        <source>it was read, but it holds neither a face nor a line</source>
        <translation>sie wurde gelesen, enthält aber weder Fläche noch Linie</translation>
    </message>
    <message>
        <source>the file cannot be read</source>
        <translation>die Datei kann nicht gelesen werden</translation>
    </message>
    <message>
        <source>the reading library says: %1</source>
        <translation>die lesende Bibliothek sagt: %1</translation>
    </message>
    <message>
        <source>the reading library cannot read it and does not say why</source>
        <translation>die lesende Bibliothek kann sie nicht lesen und sagt nicht, warum</translation>
    </message>
    <message>
        <source>save it as OBJ, PLY or STL in the program it comes from</source>
        <translation>sie in dem Programm, aus dem sie kommt, als OBJ, PLY oder STL speichern</translation>
    </message>
    <message>
        <source>mend it, or save it as OBJ, PLY or STL in the program it comes from</source>
        <translation>sie in Ordnung bringen, oder sie in dem Programm, aus dem sie kommt, als OBJ, PLY oder STL speichern</translation>
    </message>
    <message>
        <source>fetch it again, it may be cut short, or save it as OBJ, PLY or STL in the program it comes from</source>
        <translation>sie neu holen, sie ist vielleicht abgeschnitten, oder sie in dem Programm, aus dem sie kommt, als OBJ, PLY oder STL speichern</translation>
    </message>
    <message>
        <source>byte %1</source>
        <translation>Byte %1</translation>
    </message>
    <message>
        <source>&apos;%1&apos; stands where a number should be</source>
        <translation>„%1“ steht, wo eine Zahl stehen müsste</translation>
    </message>
    <message>
        <source>something else stands where a number should be</source>
        <translation>etwas anderes steht, wo eine Zahl stehen müsste</translation>
    </message>
    <message>
        <source>something else stands there than the format asks for</source>
        <translation>dort steht etwas anderes, als das Format verlangt</translation>
    </message>
    <message>
        <source>&apos;%1&apos; holds something else than it should</source>
        <translation>„%1“ enthält etwas anderes, als es müsste</translation>
    </message>
    <message>
        <source>its section &apos;%1&apos; is missing</source>
        <translation>ihr Abschnitt „%1“ fehlt</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is no word of this format</source>
        <translation>„%1“ ist kein Wort dieses Formats</translation>
    </message>
    <message>
        <source>its beginning is damaged, or it is of another format than its name says</source>
        <translation>ihr Anfang ist beschädigt, oder sie hat ein anderes Format, als ihr Name sagt</translation>
    </message>
    <message>
        <source>its header promises %1 bytes, but it has %2</source>
        <translation>ihr Kopf verspricht %1 Bytes, aber sie hat %2</translation>
    </message>
    <message>
        <source>it holds no mesh that can be read</source>
        <translation>sie enthält kein Netz, das gelesen werden kann</translation>
    </message>
    <message>
        <source>it ends too early, or a length in it is wrong</source>
        <translation>sie endet zu früh, oder eine Länge in ihr ist falsch</translation>
    </message>
    <message>
        <source>it points to data that it does not hold</source>
        <translation>sie verweist auf Daten, die sie nicht enthält</translation>
    </message>
    <message>
        <source>its ZIP archive is damaged</source>
        <translation>ihr ZIP-Archiv ist beschädigt</translation>
    </message>
    <message>
        <source>its XML is damaged</source>
        <translation>ihr XML ist beschädigt</translation>
    </message>
    <message>
        <source>its JSON is damaged</source>
        <translation>ihr JSON ist beschädigt</translation>
    </message>
    <message>
        <source>&lt;/%1&gt; ends what nothing has begun</source>
        <translation>&lt;/%1&gt; beendet, was nicht begonnen hat</translation>
    </message>
    <message>
        <source>&lt;/%1&gt; stands where &lt;/%2&gt; should, begun in line %3</source>
        <translation>&lt;/%1&gt; steht, wo &lt;/%2&gt; stehen müsste, begonnen in Zeile %3</translation>
    </message>
    <message>
        <source>a tag begins here and does not end</source>
        <translation>eine Marke beginnt hier und endet nicht</translation>
    </message>
    <message>
        <source>it ends within &lt;%1&gt;, begun in line %2</source>
        <translation>sie endet innerhalb von &lt;%1&gt;, begonnen in Zeile %2</translation>
    </message>
    <message>
        <source>the reader for this format failed</source>
        <translation>der Leser dieses Formats ist gescheitert</translation>
    </message>
    <message>
        <source>it crashed (%1), by a fault of its own or because the file is damaged</source>
        <translation>er ist abgestürzt (%1), durch einen eigenen Fehler oder weil die Datei beschädigt ist</translation>
    </message>
    <message>
        <source>it answered with garbage (%1), by a fault of its own or because the file is damaged</source>
        <translation>er hat mit Unsinn geantwortet (%1), durch einen eigenen Fehler oder weil die Datei beschädigt ist</translation>
    </message>
    <message>
        <source>convert the file to OBJ, PLY or STL</source>
        <translation>die Datei in OBJ, PLY oder STL umwandeln</translation>
    </message>
    <message>
        <source>segmentation fault</source>
        <translation>Speicherschutzfehler</translation>
    </message>
    <message>
        <source>it aborted</source>
        <translation>er brach ab</translation>
    </message>
    <message>
        <source>it ended without an answer</source>
        <translation>er endete ohne Antwort</translation>
    </message>
    <message>
        <source>bus error</source>
        <translation>Busfehler</translation>
    </message>
    <message>
        <source>arithmetic error</source>
        <translation>Rechenfehler</translation>
    </message>
    <message>
        <source>illegal instruction</source>
        <translation>unzulässiger Befehl</translation>
    </message>
    <message>
        <source>it was killed from outside, perhaps for want of memory</source>
        <translation>er wurde von außen beendet, vielleicht aus Mangel an Speicher</translation>
    </message>
    <message>
        <source>signal %1</source>
        <translation>Signal %1</translation>
    </message>
    <message>
        <source>is it cut short? Otherwise save it as OBJ, PLY or STL</source>
        <translation>ist sie abgeschnitten? Sonst als OBJ, PLY oder STL speichern</translation>
    </message>
    <message>
        <source>the reader for this format took too long for a file of this size</source>
        <translation>der Leser dieses Formats brauchte zu lang für eine Datei dieser Größe</translation>
    </message>
    <message>
        <source>the reader for this format did not end within %1 s</source>
        <translation>der Leser dieses Formats kam in %1 s nicht zum Ende</translation>
    </message>
    <message>
        <source>the file may be damaged</source>
        <translation>die Datei ist vielleicht beschädigt</translation>
    </message>
    <message>
        <source>convert it to OBJ, PLY or STL</source>
        <translation>in OBJ, PLY oder STL umwandeln</translation>
    </message>
    <message>
        <source>the program that reads this format, %1, cannot be started (%2)</source>
        <translation>das Programm, das dieses Format liest, %1, lässt sich nicht starten (%2)</translation>
    </message>
    <message>
        <source>install it again</source>
        <translation>es neu installieren</translation>
    </message>
    <message>
        <source>the repair leaves nothing of the mesh</source>
        <translation>die Reparatur lässt vom Netz nichts übrig</translation>
    </message>
    <message>
        <source>ask for less of it</source>
        <translation>weniger davon verlangen</translation>
    </message>
    <message>
        <source>edges of %1 would make more than 20 million triangles</source>
        <translation>Kanten von %1 ergäben mehr als 20 Millionen Dreiecke</translation>
    </message>
    <message>
        <source>ask for longer ones</source>
        <translation>längere verlangen</translation>
    </message>
    <message>
        <source>the net has no surface, only lines, so there is nothing that could be supported from inside or anchored</source>
        <translation>das Netz hat keine Oberfläche, nur Linien, also nichts, was von innen gestützt oder verankert werden könnte</translation>
    </message>
    <message>
        <source>the net is solid already, by the tetrahedra of its file</source>
        <translation>das Netz ist schon gefüllt, durch die Tetraeder seiner Datei</translation>
    </message>
    <message>
        <source>it needs no interior</source>
        <translation>es braucht kein Inneres</translation>
    </message>
    <message>
        <source>no strut found its way</source>
        <translation>keine Strebe fand ihren Weg</translation>
    </message>
    <message>
        <source>the surface is flat or lies open, so no wall is opposite another</source>
        <translation>die Oberfläche ist flach oder liegt offen, keine Wand liegt einer anderen gegenüber</translation>
    </message>
    <message>
        <source>no node of the surface lies in the part that is to be anchored</source>
        <translation>kein Knoten der Oberfläche liegt in dem Teil, der verankert werden soll</translation>
    </message>
    <message>
        <source>move or enlarge it</source>
        <translation>ihn verschieben oder vergrößern</translation>
    </message>
    <message>
        <source>no part of the surface is closed, so there is no volume that pressure could keep</source>
        <translation>kein Teil der Oberfläche ist geschlossen, also gibt es kein Volumen, das Druck halten könnte</translation>
    </message>
    <message>
        <source>fill its holes, or leave the pressure out</source>
        <translation>die Löcher füllen oder den Druck weglassen</translation>
    </message>
    <message>
        <source>the program %1 is not there</source>
        <translation>das Programm %1 ist nicht da</translation>
    </message>
    <message>
        <source>install it, or choose struts</source>
        <translation>es installieren oder Streben wählen</translation>
    </message>
    <message>
        <source>the program %1 failed (%2)</source>
        <translation>das Programm %1 ist gescheitert (%2)</translation>
    </message>
    <message>
        <source>a lattice needs a closed surface to lie in</source>
        <translation>ein Gitter braucht eine geschlossene Oberfläche um sich</translation>
    </message>
    <message>
        <source>fill its holes, or choose struts</source>
        <translation>die Löcher füllen oder Streben wählen</translation>
    </message>
    <message>
        <source>tetrahedra need a closed surface without edges of three triangles</source>
        <translation>Tetraeder brauchen eine geschlossene Oberfläche ohne Kanten dreier Dreiecke</translation>
    </message>
    <message>
        <source>repair it, or choose struts</source>
        <translation>sie reparieren oder Streben wählen</translation>
    </message>
    <message>
        <source>repair the surface, or choose struts</source>
        <translation>die Oberfläche reparieren oder Streben wählen</translation>
    </message>
    <message>
        <source>no node of the lattice fits into the body</source>
        <translation>kein Gitterknoten passt in den Körper</translation>
    </message>
    <message>
        <source>choose a smaller cell, or struts</source>
        <translation>eine kleinere Zelle oder Streben wählen</translation>
    </message>
    <message>
        <source>a wall needs a thickness above 0 m</source>
        <translation>eine Wand braucht eine Dicke über 0 m</translation>
    </message>
    <message>
        <source>a wall of %1 mm has no room in most of the body</source>
        <translation>eine Wand von %1 mm hat im größten Teil des Körpers keinen Platz</translation>
    </message>
    <message>
        <source>choose a thinner wall (up to %1 mm fit at the widest place), or a lattice</source>
        <translation>eine dünnere Wand wählen (bis zu %1 mm passen an der weitesten Stelle) oder ein Gitter</translation>
    </message>
    <message>
        <source>the surface has no inside (an edge of three triangles, or one side only), so a wall cannot lie on it</source>
        <translation>die Oberfläche hat kein Innen (eine Kante mit drei Dreiecken, oder nur eine Seite), also kann keine Wand auf ihr liegen</translation>
    </message>
    <message>
        <source>the body has a cavity in the file, so its wall is there already</source>
        <translation>der Körper hat in der Datei schon einen Hohlraum, also ist seine Wand schon da</translation>
    </message>
    <message>
        <source>choose struts or tetrahedra, or import the outer surface alone</source>
        <translation>Streben oder Tetraeder wählen, oder nur die äußere Oberfläche importieren</translation>
    </message>
    <message>
        <source>the wall would have millions of nodes</source>
        <translation>die Wand hätte Millionen Knoten</translation>
    </message>
    <message>
        <source>take fewer layers or a coarser mesh</source>
        <translation>weniger Lagen oder ein gröberes Netz nehmen</translation>
    </message>
    <message>
        <source>the wall has no volume: the surface has no area</source>
        <translation>die Wand hat kein Volumen: die Oberfläche hat keine Fläche</translation>
    </message>
    <message>
        <source>the surface is not closed, so it has no volume that could be filled with tissue</source>
        <translation>die Oberfläche ist nicht geschlossen, hat also kein Volumen, das Gewebe füllen könnte</translation>
    </message>
    <message>
        <source>fill its holes, or choose the wall</source>
        <translation>die Löcher füllen oder die Wand wählen</translation>
    </message>
    <message>
        <source>no single input of the rules makes the %1 %2</source>
        <translation>keine einzelne Eingabe der Regeln ergibt %1 = %2</translation>
    </message>
    <message>
        <source>the nearest that one reaches is %1</source>
        <translation>am nächsten kommt %1</translation>
    </message>
    <message>
        <source>is damaged from its first line on</source>
        <translation>ist von der ersten Zeile an beschädigt</translation>
    </message>
    <message>
        <source>was written by a newer version of this program</source>
        <translation>wurde von einer neueren Fassung dieses Programms geschrieben</translation>
    </message>
    <message>
        <source>%1 is not as it was written</source>
        <translation>%1 ist nicht, wie es geschrieben wurde</translation>
    </message>
    <message>
        <source>does not fit its own beginning (%1)</source>
        <translation>passt nicht zum eigenen Anfang (%1)</translation>
    </message>
    <message>
        <source>holds nodes that the net does not have</source>
        <translation>hält Knoten fest, die das Netz nicht hat</translation>
    </message>
    <message>
        <source>names a file outside of its folder</source>
        <translation>nennt eine Datei außerhalb des eigenen Ordners</translation>
    </message>
    <message>
        <source>there is no state folder: neither XDG_STATE_HOME nor HOME is set</source>
        <translation>es gibt keinen Ordner für Zustände: weder XDG_STATE_HOME noch HOME ist gesetzt</translation>
    </message>
    <message>
        <source>it holds %1 vertices but no face (f) and no line (l), points alone make no net</source>
        <translation>sie enthält %1 Ecken, aber keine Fläche (f) und keine Linie (l), aus Punkten allein wird kein Netz</translation>
    </message>
    <message>
        <source>a point cloud makes no net, make a surface of it first</source>
        <translation>aus einer Punktwolke wird kein Netz, zuerst eine Oberfläche daraus machen</translation>
    </message>
    <message>
        <source>this is %1</source>
        <translation>das ist %1</translation>
    </message>
    <message>
        <source>a picture holds no mesh, choose the mesh file itself</source>
        <translation>ein Bild enthält kein Netz, die Netzdatei selbst wählen</translation>
    </message>
    <message>
        <source>unpack it and choose the mesh in it</source>
        <translation>entpacken und das Netz darin wählen</translation>
    </message>
    <message>
        <source>segment the organ in an imaging program such as 3D Slicer, and save its surface as STL, OBJ or PLY</source>
        <translation>das Organ in einem Bildprogramm wie 3D Slicer segmentieren und seine Oberfläche als STL, OBJ oder PLY speichern</translation>
    </message>
    <message>
        <source>mesh it in the CAD program and save that as STL or OBJ</source>
        <translation>im CAD-Programm vernetzen und das als STL oder OBJ speichern</translation>
    </message>
    <message>
        <source>convert it to VTU or Gmsh .msh, as meshio, Gmsh or the program it comes from can do</source>
        <translation>in VTU oder Gmsh .msh umwandeln, was meshio, Gmsh oder das Programm kann, aus dem sie kommt</translation>
    </message>
    <message>
        <source>make a surface of its points, in MeshLab for example, and save that as PLY</source>
        <translation>aus ihren Punkten eine Oberfläche machen, etwa in MeshLab, und diese als PLY speichern</translation>
    </message>
    <message>
        <source>save it as OBJ, PLY, STL or glTF in the program it comes from</source>
        <translation>in dem Programm, aus dem sie kommt, als OBJ, PLY, STL oder glTF speichern</translation>
    </message>
    <message>
        <source>choose a mesh file</source>
        <translation>eine Netzdatei wählen</translation>
    </message>
    <message>
        <source>save it as UTF-8</source>
        <translation>als UTF-8 speichern</translation>
    </message>
    <message>
        <source>UTF-16 text</source>
        <translation>UTF-16-Text</translation>
    </message>
    <message>
        <source>a program</source>
        <translation>ein Programm</translation>
    </message>
    <message>
        <source>a database</source>
        <translation>eine Datenbank</translation>
    </message>
    <message>
        <source>a film or HEIF picture</source>
        <translation>ein Film oder HEIF-Bild</translation>
    </message>
    <message>
        <source>a sound, picture or film</source>
        <translation>ein Ton, Bild oder Film</translation>
    </message>
    <message>
        <source>an empty ZIP archive</source>
        <translation>ein leeres ZIP-Archiv</translation>
    </message>
    <message>
        <source>a MetaImage</source>
        <translation>ein MetaImage</translation>
    </message>
    <message>
        <source>an HDF5 file, as CGNS, MED, Exodus or MINC use it</source>
        <translation>eine HDF5-Datei, wie CGNS, MED, Exodus oder MINC sie nutzen</translation>
    </message>
    <message>
        <source>a NetCDF file, as Exodus uses it</source>
        <translation>eine NetCDF-Datei, wie Exodus sie nutzt</translation>
    </message>
    <message>
        <source>a STEP file, which holds surfaces and no mesh</source>
        <translation>eine STEP-Datei, die Flächen enthält und kein Netz</translation>
    </message>
    <message>
        <source>an IGES file, which holds surfaces and no mesh</source>
        <translation>eine IGES-Datei, die Flächen enthält und kein Netz</translation>
    </message>
    <message>
        <source>an OpenFOAM file</source>
        <translation>eine OpenFOAM-Datei</translation>
    </message>
    <message>
        <source>a Tecplot file</source>
        <translation>eine Tecplot-Datei</translation>
    </message>
    <message>
        <source>a TetGen file</source>
        <translation>eine TetGen-Datei</translation>
    </message>
    <message>
        <source>an XDMF file</source>
        <translation>eine XDMF-Datei</translation>
    </message>
    <message>
        <source>a DWG drawing</source>
        <translation>eine DWG-Zeichnung</translation>
    </message>
    <message>
        <source>a Rhino model</source>
        <translation>ein Rhino-Modell</translation>
    </message>
    <message>
        <source>a SketchUp model</source>
        <translation>ein SketchUp-Modell</translation>
    </message>
    <message>
        <source>an FEBio model</source>
        <translation>ein FEBio-Modell</translation>
    </message>
    <message>
        <source>a Gmsh geometry</source>
        <translation>eine Gmsh-Geometrie</translation>
    </message>
    <message>
        <source>an OpenSCAD script</source>
        <translation>ein OpenSCAD-Skript</translation>
    </message>
    <message>
        <source>a web page</source>
        <translation>eine Webseite</translation>
    </message>
    <message>
        <source>a packed XGL scene</source>
        <translation>eine gepackte XGL-Szene</translation>
    </message>
    <message>
        <source>a CAD part of NX or Creo</source>
        <translation>ein CAD-Teil von NX oder Creo</translation>
    </message>
    <message>
        <source>a SolidWorks assembly</source>
        <translation>eine SolidWorks-Baugruppe</translation>
    </message>
    <message>
        <source>an Autodesk Inventor assembly</source>
        <translation>eine Autodesk-Inventor-Baugruppe</translation>
    </message>
    <message>
        <source>a part of SolidWorks, Inventor or Solid Edge, a 3ds Max scene or an old office document</source>
        <translation>ein Teil von SolidWorks, Inventor oder Solid Edge, eine 3ds-Max-Szene oder ein altes Office-Dokument</translation>
    </message>
    <message>
        <source>a pointer of Git LFS to the file</source>
        <translation>ein Zeiger von Git LFS auf die Datei</translation>
    </message>
    <message>
        <source>fetch the file itself with git lfs pull</source>
        <translation>die Datei selbst mit git lfs pull holen</translation>
    </message>
    <message>
        <source>a table of numbers, perhaps points</source>
        <translation>eine Tabelle von Zahlen, vielleicht von Punkten</translation>
    </message>
    <message>
        <source>a universal (UNV) deck</source>
        <translation>ein Universal-Deck (UNV)</translation>
    </message>
    <message>
        <source>an Abaqus or CalculiX deck</source>
        <translation>ein Deck von Abaqus oder CalculiX</translation>
    </message>
    <message>
        <source>a %1 deck</source>
        <translation>ein %1-Deck</translation>
    </message>
    <message>
        <source>an %1 deck</source>
        <translation>ein %1-Deck</translation>
    </message>
    <message>
        <source>JSON text, but no glTF</source>
        <translation>JSON-Text, aber kein glTF</translation>
    </message>
    <message>
        <source>XML text of an unknown kind</source>
        <translation>XML-Text unbekannter Art</translation>
    </message>
    <message>
        <source>choose the mesh file that it names</source>
        <translation>die Netzdatei wählen, die darin genannt ist</translation>
    </message>
    <message>
        <source>convert it with tetgen -k, which writes VTK</source>
        <translation>mit tetgen -k umwandeln, das VTK schreibt</translation>
    </message>
    <message>
        <source>mesh it in Gmsh and save that as .msh</source>
        <translation>in Gmsh vernetzen und das als .msh speichern</translation>
    </message>
    <message>
        <source>render it in OpenSCAD and save that as STL or OFF</source>
        <translation>in OpenSCAD berechnen und das als STL oder OFF speichern</translation>
    </message>
    <message>
        <source>save it as DXF in text (ASCII) or as STL</source>
        <translation>als DXF in Textform (ASCII) oder als STL speichern</translation>
    </message>
    <message>
        <source>the key &quot;%1&quot; occurs twice in one object</source>
        <translation>der Schlüssel „%1“ steht zweimal in einem Objekt</translation>
    </message>
    <message>
        <source>its part &apos;%1&apos; is missing here</source>
        <translation>ihr Teil „%1“ fehlt hier</translation>
    </message>
    <message>
        <source>it lies outside the model&apos;s folder and stays closed</source>
        <translation>es liegt außerhalb des Ordners des Modells und bleibt geschlossen</translation>
    </message>
    <message>
        <source>it is no regular file and stays closed</source>
        <translation>es ist keine gewöhnliche Datei und bleibt geschlossen</translation>
    </message>
    <message>
        <source>there is no such file in the model&apos;s folder</source>
        <translation>im Ordner des Modells gibt es keine solche Datei</translation>
    </message>
    <message>
        <source>nothing is fetched from other machines</source>
        <translation>von anderen Rechnern wird nichts geholt</translation>
    </message>
    <message>
        <source>the archive does not hold it</source>
        <translation>das Archiv enthält es nicht</translation>
    </message>
    <message>
        <source>it would be a part of itself</source>
        <translation>es wäre ein Teil von sich selbst</translation>
    </message>
    <message>
        <source>it cannot be read</source>
        <translation>es ist nicht lesbar</translation>
    </message>
    <message>
        <source>%1 more of its parts are missing</source>
        <translation>weitere fehlende Teile: %1</translation>
    </message>
    <message>
        <source>put its parts beside it, or save it as OBJ, PLY or STL in the program it comes from</source>
        <translation>die Teile daneben legen, oder sie in dem Programm, aus dem sie kommt, als OBJ, PLY oder STL speichern</translation>
    </message>
    <message>
        <source>files that an OBJ calls are not read</source>
        <translation>Dateien, die eine OBJ-Datei aufruft, werden nicht gelesen</translation>
    </message>
    <message>
        <source>of an X3D scene only X3D parts are read</source>
        <translation>von einer X3D-Szene werden nur X3D-Teile gelesen</translation>
    </message>
    <message>
        <source>parts of parts of an X3D scene are not read</source>
        <translation>Teile von Teilen einer X3D-Szene werden nicht gelesen</translation>
    </message>
    <message>
        <source>parts in other COLLADA files are not read</source>
        <translation>Teile in anderen COLLADA-Dateien werden nicht gelesen</translation>
    </message>
    <message>
        <source>a %1 picture</source>
        <translation>ein %1-Bild</translation>
    </message>
    <message>
        <source>a %1 archive</source>
        <translation>ein %1-Archiv</translation>
    </message>
    <message>
        <source>a %1 image</source>
        <translation>eine %1-Aufnahme</translation>
    </message>
    <message>
        <source>a %1 mesh</source>
        <translation>ein %1-Netz</translation>
    </message>
    <message>
        <source>a %1 part</source>
        <translation>ein %1-Teil</translation>
    </message>
    <message>
        <source>a %1 scene</source>
        <translation>eine %1-Szene</translation>
    </message>
    <message>
        <source>a %1 point cloud</source>
        <translation>eine %1-Punktwolke</translation>
    </message>
    <message>
        <source>a %1 document</source>
        <translation>ein %1-Dokument</translation>
    </message>
    <message>
        <source>an %1 picture</source>
        <translation>ein %1-Bild</translation>
    </message>
    <message>
        <source>an %1 archive</source>
        <translation>ein %1-Archiv</translation>
    </message>
    <message>
        <source>an %1 image</source>
        <translation>eine %1-Aufnahme</translation>
    </message>
    <message>
        <source>an %1 mesh</source>
        <translation>ein %1-Netz</translation>
    </message>
    <message>
        <source>an %1 part</source>
        <translation>ein %1-Teil</translation>
    </message>
    <message>
        <source>an %1 scene</source>
        <translation>eine %1-Szene</translation>
    </message>
    <message>
        <source>an %1 point cloud</source>
        <translation>eine %1-Punktwolke</translation>
    </message>
    <message>
        <source>an %1 document</source>
        <translation>ein %1-Dokument</translation>
    </message>
    <message>
        <source>a binary OFF</source>
        <translation>eine binäre OFF-Datei</translation>
    </message>
    <message>
        <source>an X3D scene in the encoding of VRML</source>
        <translation>eine X3D-Szene in der Schreibweise von VRML</translation>
    </message>
    <message>
        <source>save it as .x3d in XML, or as VRML 97 (.wrl)</source>
        <translation>speichern Sie sie als .x3d in XML oder als VRML 97 (.wrl)</translation>
    </message>
    <message>
        <source>a program for a 3D printer</source>
        <translation>ein Programm für einen 3D-Drucker</translation>
    </message>
    <message>
        <source>a list of an OBJ&apos;s materials</source>
        <translation>eine Liste der Materialien einer OBJ-Datei</translation>
    </message>
    <message>
        <source>choose the .obj that it belongs to</source>
        <translation>wählen Sie die .obj-Datei, zu der sie gehört</translation>
    </message>
    <message>
        <source>a project of this program</source>
        <translation>ein Projekt dieses Programms</translation>
    </message>
    <message>
        <source>open it, or ask esm info of it</source>
        <translation>öffnen Sie es, oder befragen Sie es mit esm info</translation>
    </message>
    <message>
        <source>a net with numbers of its own</source>
        <translation>ein Netz mit eigenen Zahlen</translation>
    </message>
    <message>
        <source>open it, or make a project of it by esm import</source>
        <translation>öffnen Sie es, oder machen Sie mit esm import ein Projekt daraus</translation>
    </message>
    <message>
        <source>it needs the glTF extension %1, which is not read</source>
        <translation>sie braucht die glTF-Erweiterung %1, die nicht gelesen wird</translation>
    </message>
    <message>
        <source>save it without (gltfpack: with -noq and without -c)</source>
        <translation>speichern Sie sie ohne diese (gltfpack: mit -noq und ohne -c)</translation>
    </message>
    <message>
        <source>a shape uses vertex %1, counted from 0, but it has %2</source>
        <translation>eine Form verwendet Ecke %1, von 0 an gezählt, hat aber %2</translation>
    </message>
    <message>
        <source>mend it in the program it comes from</source>
        <translation>bessern Sie sie in dem Programm aus, aus dem sie kommt</translation>
    </message>
    <message>
        <source>a pipe that nobody reads</source>
        <translation>eine Pipe, die niemand liest</translation>
    </message>
    <message>
        <source>X3D line sets are not read (the library would make polygons of them)</source>
        <translation>X3D-Linien werden nicht gelesen (die Bibliothek machte Polygone daraus)</translation>
    </message>
    <message>
        <source>save it as VRML, OBJ or PLY</source>
        <translation>sie als VRML, OBJ oder PLY speichern</translation>
    </message>
    <message>
        <source>it holds no line, polyline or face, only %1</source>
        <translation>sie enthält keine Linie, Polylinie oder Fläche, nur %1</translation>
    </message>
    <message>
        <source>%1 entities in paper space</source>
        <translation>%1 Objekte im Papierbereich</translation>
    </message>
    <message>
        <source>%1 invisible entities</source>
        <translation>%1 unsichtbare Objekte</translation>
    </message>
    <message>
        <source>%1 entities on layers that are frozen or off (%2)</source>
        <translation>%1 Objekte auf gefrorenen oder ausgeschalteten Layern (%2)</translation>
    </message>
    <message>
        <source>%1 INSERT without its block</source>
        <translation>%1 INSERT ohne seinen Block</translation>
    </message>
    <message>
        <source>external drawings ('%1')</source>
        <translation>externe Zeichnungen („%1“)</translation>
    </message>
    <message>
        <source>external drawings ('%1' ...)</source>
        <translation>externe Zeichnungen („%1“ ...)</translation>
    </message>
    <message>
        <source>convert curves to polylines in the drawing program</source>
        <translation>Kurven im Zeichenprogramm in Polylinien wandeln</translation>
    </message>
    <message>
        <source>save solids and surfaces as STL</source>
        <translation>Körper und Flächen als STL speichern</translation>
    </message>
    <message>
        <source>draw filled areas as 3DFACE or polylines</source>
        <translation>gefüllte Flächen als 3DFACE oder Polylinien zeichnen</translation>
    </message>
    <message>
        <source>bind external drawings in the drawing program</source>
        <translation>externe Zeichnungen im Zeichenprogramm binden</translation>
    </message>
    <message>
        <source>move what is wanted to model space and show it</source>
        <translation>das Gewünschte in den Modellbereich legen und sichtbar machen</translation>
    </message>
    <message>
        <source>external drawings are not read</source>
        <translation>externe Zeichnungen werden nicht gelesen</translation>
    </message>
    <message>
        <source>bind them in the drawing program</source>
        <translation>sie im Zeichenprogramm binden</translation>
    </message>
    <message>
        <source>a face of this POLYLINE uses vertex %1, but it has %2</source>
        <translation>eine Fläche dieser POLYLINE nennt Punkt %1, sie hat aber %2</translation>
    </message>
    <message>
        <source>blocks are nested too deep</source>
        <translation>Blöcke sind zu tief geschachtelt</translation>
    </message>
    <message>
        <source>is a block inside itself?</source>
        <translation>enthält ein Block sich selbst?</translation>
    </message>
    <message>
        <source>it places its blocks more often than a drawing of its size should</source>
        <translation>sie setzt ihre Blöcke öfter ein, als es eine Zeichnung ihrer Größe sollte</translation>
    </message>
    <message>
        <source>explode them first</source>
        <translation>sie zuerst auflösen</translation>
    </message>
    <message>
        <source>the file ends within this POLYLINE</source>
        <translation>die Datei endet in dieser POLYLINE</translation>
    </message>
    <message>
        <source>this %1 has a coordinate that is no finite number (numbers are written with a point)</source>
        <translation>dieses Objekt (%1) hat eine Koordinate, die keine endliche Zahl ist (Zahlen schreibt man mit Punkt)</translation>
    </message>
    <message>
        <source>this POLYLINE mesh says %1 x %2 vertices, but it has %3</source>
        <translation>dieses POLYLINE-Netz nennt %1 x %2 Punkte, es hat aber %3</translation>
    </message>
    <message>
        <source>%1 nodes</source>
        <translation>%1 Knoten</translation>
    </message>
    <message>
        <source>%1 elements</source>
        <translation>%1 Elemente</translation>
    </message>
    <message>
        <source>%1 blocks of nodes</source>
        <translation>%1 Blöcke von Knoten</translation>
    </message>
    <message>
        <source>%1 blocks of elements</source>
        <translation>%1 Blöcke von Elementen</translation>
    </message>
    <message>
        <source>%1 points</source>
        <translation>%1 Punkte</translation>
    </message>
    <message>
        <source>%1 numbers</source>
        <translation>%1 Zahlen</translation>
    </message>
    <message>
        <source>%1 values of a field</source>
        <translation>%1 Werte eines Feldes</translation>
    </message>
    <message>
        <source>a binary Gmsh file needs sizes of 8 bytes</source>
        <translation>eine binäre Gmsh-Datei braucht Größen von 8 Byte</translation>
    </message>
    <message>
        <source>save it as text, or as binary in format 4.1 or 2.2</source>
        <translation>sie als Text oder binär im Format 4.1 oder 2.2 speichern</translation>
    </message>
    <message>
        <source>an element has impossible counts</source>
        <translation>ein Element nennt unmögliche Anzahlen</translation>
    </message>
    <message>
        <source>element %1 has %2 nodes, its type wants %3</source>
        <translation>Element %1 hat %2 Knoten, seine Art verlangt %3</translation>
    </message>
    <message>
        <source>the section $MeshFormat must come first</source>
        <translation>der Abschnitt $MeshFormat muss zuerst kommen</translation>
    </message>
    <message>
        <source>$MeshFormat needs version, type and size</source>
        <translation>$MeshFormat braucht Version, Art und Größe</translation>
    </message>
    <message>
        <source>the recipe names no mesh file</source>
        <translation>das Rezept nennt keine Netzdatei</translation>
    </message>
    <message>
        <source>it may be cut short</source>
        <translation>vielleicht ist sie abgeschnitten</translation>
    </message>
    <message>
        <source>it ends early</source>
        <translation>sie endet zu früh</translation>
    </message>
    <message>
        <source>the file is cut short, fetch it again</source>
        <translation>die Datei ist abgeschnitten, neu holen</translation>
    </message>
    <message>
        <source>the file is damaged or cut short</source>
        <translation>die Datei ist beschädigt oder abgeschnitten</translation>
    </message>
    <message>
        <source>the file may be cut short</source>
        <translation>vielleicht ist die Datei abgeschnitten</translation>
    </message>
    <message>
        <source>a PLY header line begins with '%1', which is no word of PLY</source>
        <translation>eine Zeile des PLY-Anfangs beginnt mit „%1“; das ist kein Wort von PLY</translation>
    </message>
    <message>
        <source>remarks begin with the word comment</source>
        <translation>Bemerkungen beginnen mit dem Wort comment</translation>
    </message>
    <message>
        <source>a list property needs a count type that PLY knows</source>
        <translation>eine Liste (property list) braucht eine Zählart, die PLY kennt</translation>
    </message>
    <message>
        <source>a property comes before the first element</source>
        <translation>eine Eigenschaft (property) steht vor dem ersten Element</translation>
    </message>
    <message>
        <source>a property has a type that PLY does not know</source>
        <translation>eine Eigenschaft (property) hat eine Art, die PLY nicht kennt</translation>
    </message>
    <message>
        <source>a property has no name</source>
        <translation>eine Eigenschaft (property) hat keinen Namen</translation>
    </message>
    <message>
        <source>an element needs a name and a count from 0</source>
        <translation>ein Element braucht einen Namen und eine Anzahl ab 0</translation>
    </message>
    <message>
        <source>the element '%1' comes twice</source>
        <translation>das Element „%1“ kommt zweimal</translation>
    </message>
    <message>
        <source>a range grid is a scan that must be triangulated first, as MeshLab does</source>
        <translation>ein Abstandsraster (range grid) ist eine Abtastung, die zuerst in Dreiecke zerlegt werden muss, etwa mit MeshLab</translation>
    </message>
    <message>
        <source>it has lists in the element '%1', which is none of those that are known</source>
        <translation>sie hat Listen im Element „%1“, das keines der bekannten ist</translation>
    </message>
    <message>
        <source>save it with faces</source>
        <translation>sie mit Flächen speichern</translation>
    </message>
    <message>
        <source>its edges have no vertex1 and vertex2</source>
        <translation>ihre Kanten haben kein vertex1 und vertex2</translation>
    </message>
    <message>
        <source>a list of impossible length</source>
        <translation>eine Liste unmöglicher Länge</translation>
    </message>
    <message>
        <source>unknown PLY encoding</source>
        <translation>unbekannte PLY-Kodierung</translation>
    </message>
    <message>
        <source>'%1' is no number</source>
        <translation>„%1“ ist keine Zahl</translation>
    </message>
    <message>
        <source>its line has fewer numbers than the header says</source>
        <translation>ihre Zeile hat weniger Zahlen, als der Anfang sagt</translation>
    </message>
    <message>
        <source>a line of a RAW file has 9 or 12 numbers, this one has %1</source>
        <translation>eine Zeile einer RAW-Datei hat 9 oder 12 Zahlen, diese hat %1</translation>
    </message>
    <message>
        <source>it holds no triangle</source>
        <translation>sie enthält kein Dreieck</translation>
    </message>
    <message>
        <source>nor do these hold a whole number of facets, so it is no STL or damaged</source>
        <translation>auch ergeben diese keine ganze Zahl von Facetten; sie ist also kein STL oder beschädigt</translation>
    </message>
    <message>
        <source>the file ends within a facet</source>
        <translation>die Datei endet in einer Facette</translation>
    </message>
    <message>
        <source>a VTK file goes on with DATASET</source>
        <translation>eine VTK-Datei geht mit DATASET weiter</translation>
    </message>
    <message>
        <source>a cell has an impossible number of nodes</source>
        <translation>eine Zelle hat eine unmögliche Anzahl von Knoten</translation>
    </message>
    <message>
        <source>a count from 0 is missing</source>
        <translation>eine Anzahl ab 0 fehlt</translation>
    </message>
    <message>
        <source>cell %1 has %2 nodes, its type wants %3</source>
        <translation>Zelle %1 hat %2 Knoten, ihre Art verlangt %3</translation>
    </message>
    <message>
        <source>a cell has %1 nodes, its type wants %2</source>
        <translation>eine Zelle hat %1 Knoten, ihre Art verlangt %2</translation>
    </message>
    <message>
        <source>field data of the type '%1' before the points is not read</source>
        <translation>Felddaten der Art „%1“ vor den Punkten werden nicht gelesen</translation>
    </message>
    <message>
        <source>save the file without it</source>
        <translation>die Datei ohne sie speichern</translation>
    </message>
    <message>
        <source>its cells have no CELL_TYPES</source>
        <translation>ihre Zellen haben keine CELL_TYPES</translation>
    </message>
    <message>
        <source>it ends before OFFSETS and CONNECTIVITY of the cells</source>
        <translation>sie endet vor OFFSETS und CONNECTIVITY der Zellen</translation>
    </message>
    <message>
        <source>OFFSETS and CONNECTIVITY of the cells are missing</source>
        <translation>OFFSETS und CONNECTIVITY der Zellen fehlen</translation>
    </message>
    <message>
        <source>the cells have a type that VTK does not know</source>
        <translation>die Zellen haben eine Art, die VTK nicht kennt</translation>
    </message>
    <message>
        <source>the points have a type that VTK does not know</source>
        <translation>die Punkte haben eine Art, die VTK nicht kennt</translation>
    </message>
    <message>
        <source>the offsets of its cells are impossible</source>
        <translation>die Versätze (offsets) ihrer Zellen sind unmöglich</translation>
    </message>
    <message>
        <source>the third line of a VTK file says ASCII or BINARY</source>
        <translation>die dritte Zeile einer VTK-Datei heißt ASCII oder BINARY</translation>
    </message>
    <message>
        <source>they are no string</source>
        <translation>sie sind kein Text</translation>
    </message>
    <message>
        <source>the array '%1' %2</source>
        <translation>das Feld „%1“ %2</translation>
    </message>
    <message>
        <source>cannot be unpacked</source>
        <translation>lässt sich nicht entpacken</translation>
    </message>
    <message>
        <source>ends early</source>
        <translation>endet zu früh</translation>
    </message>
    <message>
        <source>has no size</source>
        <translation>hat keine Größe</translation>
    </message>
    <message>
        <source>has no sizes</source>
        <translation>hat keine Größen</translation>
    </message>
    <message>
        <source>holds something that is no number</source>
        <translation>enthält etwas, das keine Zahl ist</translation>
    </message>
    <message>
        <source>promises more than the file holds</source>
        <translation>verspricht mehr, als die Datei enthält</translation>
    </message>
    <message>
        <source>a VTK file of the type '%1' is no mesh of cells</source>
        <translation>eine VTK-Datei der Art „%1“ ist kein Netz aus Zellen</translation>
    </message>
    <message>
        <source>save it as VTU or VTP</source>
        <translation>sie als VTU oder VTP speichern</translation>
    </message>
    <message>
        <source>an array begins before the data</source>
        <translation>ein Feld beginnt vor den Daten</translation>
    </message>
    <message>
        <source>an array has a type that VTK does not know</source>
        <translation>ein Feld hat eine Art, die VTK nicht kennt</translation>
    </message>
    <message>
        <source>it has no Cells</source>
        <translation>sie hat keine Zellen (Cells)</translation>
    </message>
    <message>
        <source>it has no Points</source>
        <translation>sie hat keine Punkte (Points)</translation>
    </message>
    <message>
        <source>it promises %1 points, but it has %2</source>
        <translation>sie verspricht %1 Punkte, es sind aber %2</translation>
    </message>
    <message>
        <source>its cells lack connectivity, offsets or types</source>
        <translation>ihren Zellen fehlen connectivity, offsets oder types</translation>
    </message>
    <message>
        <source>its compressor %1 is not read</source>
        <translation>ihre Kompression %1 wird nicht gelesen</translation>
    </message>
    <message>
        <source>save it with zlib or without compression</source>
        <translation>sie mit zlib oder unkomprimiert speichern</translation>
    </message>
    <message>
        <source>there is no point %1, its piece has points 0 to %2</source>
        <translation>Punkt %1 gibt es nicht, ihr Stück hat die Punkte 0 bis %2</translation>
    </message>
    <message>
        <source>a face uses vertex %1, but its mesh has %2</source>
        <translation>eine Fläche nennt Punkt %1, ihr Netz hat aber %2</translation>
    </message>
    <message>
        <source>a node names a mesh that the file does not hold</source>
        <translation>ein Knoten nennt ein Netz, das die Datei nicht enthält</translation>
    </message>
    <message>
        <source>the scene has more than %1 parts</source>
        <translation>die Szene hat mehr als %1 Teile</translation>
    </message>
    <message>
        <source>it needs more memory than a file of its size should</source>
        <translation>sie braucht mehr Speicher, als es eine Datei ihrer Größe sollte</translation>
    </message>
    <message>
        <source>it may be damaged, or simplify it first</source>
        <translation>vielleicht ist sie beschädigt, oder sie zuerst vereinfachen</translation>
    </message>
    <message>
        <source>the %1 library gave up on it (%2)</source>
        <translation>die Bibliothek %1 kam nicht weiter (%2)</translation>
    </message>
    <message>
        <source>the %1 library gave up on it</source>
        <translation>die Bibliothek %1 kam nicht weiter</translation>
    </message>
    <message>
        <source>a face or line of it uses a vertex that is not there or not finite</source>
        <translation>eine Fläche oder Linie darin nennt einen Punkt, den es nicht gibt oder der nicht endlich ist</translation>
    </message>
    <message>
        <source>it does not name the format</source>
        <translation>es nennt das Format nicht</translation>
    </message>
    <message>
        <source>it holds %1 bytes where its head promises %2</source>
        <translation>es hat %1 Byte, wo der Anfang %2 verspricht</translation>
    </message>
    <message>
        <source>it refuses the file without a reason</source>
        <translation>es weist die Datei ohne Grund ab</translation>
    </message>
    <message>
        <source>its head is not that of a reply</source>
        <translation>sein Anfang ist nicht der einer Antwort</translation>
    </message>
    <message>
        <source>exit code %1</source>
        <translation>Rückgabewert %1</translation>
    </message>
    <message>
        <source>%1 lines behind the %2 were passed over, the first is line %3</source>
        <translation>%1 Zeilen hinter den %2 wurden übergangen, die erste ist Zeile %3</translation>
    </message>
    <message>
        <source>%1 promised nodes</source>
        <translation>%1 versprochenen Knoten</translation>
    </message>
    <message>
        <source>%1 promised elements</source>
        <translation>%1 versprochenen Elementen</translation>
    </message>
    <message>
        <source>%1 promised faces</source>
        <translation>%1 versprochenen Flächen</translation>
    </message>
    <message>
        <source>it promises %1 cells, but it has %2</source>
        <translation>sie verspricht %1 Zellen, es sind aber %2</translation>
    </message>
    <message>
        <source>it has %1 CELL_TYPES for %2 CELLS</source>
        <translation>sie hat %1 CELL_TYPES für %2 CELLS</translation>
    </message>
    <message>
        <source>it has %1 types for %2 offsets of its cells</source>
        <translation>sie hat %1 Arten (types) für %2 Versätze (offsets) ihrer Zellen</translation>
    </message>
    <message>
        <source>'%1' of %2 holds something else than it should</source>
        <translation>„%1“ von %2 enthält etwas anderes, als es sollte</translation>
    </message>
    <message>
        <source>its FBX version, %1, is not read, those from 7100 (FBX 2011) on are</source>
        <translation>ihre FBX-Version %1 wird nicht gelesen, erst die ab 7100 (FBX 2011) werden es</translation>
    </message>
    <message>
        <source>its glTF version is not read, 2.0 is</source>
        <translation>ihre glTF-Version wird nicht gelesen, 2.0 schon</translation>
    </message>
    <message>
        <source>it names %1, but holds %2 of these</source>
        <translation>sie nennt %1, enthält davon aber nur %2</translation>
    </message>
    <message>
        <source>something in it is a part of itself</source>
        <translation>etwas in ihr ist ein Teil seiner selbst</translation>
    </message>
    <message>
        <source>data that are packed in it cannot be unpacked</source>
        <translation>gepackte Daten in ihr lassen sich nicht entpacken</translation>
    </message>
    <message>
        <source>its part '%1'</source>
        <translation>ihr Teil „%1“</translation>
    </message>
    <message>
        <source>its part '%1' is empty</source>
        <translation>ihr Teil „%1“ ist leer</translation>
    </message>
    <message>
        <source>its part '%1' cannot be unpacked</source>
        <translation>ihr Teil „%1“ lässt sich nicht entpacken</translation>
    </message>
    <message>
        <source>its part '%1' is packed by method %2, which is not read</source>
        <translation>ihr Teil „%1“ ist nach Verfahren %2 gepackt, das nicht gelesen wird</translation>
    </message>
    <message>
        <source>its &lt;build&gt; places none of its objects</source>
        <translation>ihr &lt;build&gt; setzt keines ihrer Objekte ein</translation>
    </message>
    <message>
        <source>'%1' stands behind as many numbers as were promised</source>
        <translation>„%1“ steht hinter so vielen Zahlen, wie versprochen waren</translation>
    </message>
    <message>
        <source>is a count too small?</source>
        <translation>ist eine Anzahl zu klein?</translation>
    </message>
</context>
<context>
    <name>esm::ErrorText</name>
    <message>
        <source>The file cannot be read.</source>
        <translation>Die Datei kann nicht gelesen werden.</translation>
    </message>
    <message>
        <source>The file cannot be written.</source>
        <translation>Die Datei kann nicht geschrieben werden.</translation>
    </message>
    <message>
        <source>The file is damaged or of another format.</source>
        <translation>Die Datei ist beschädigt oder hat ein anderes Format.</translation>
    </message>
    <message>
        <source>This format or feature is not supported.</source>
        <translation>Dieses Format oder Merkmal wird nicht unterstützt.</translation>
    </message>
    <message>
        <source>The file was written by a newer version of this program.</source>
        <translation>Die Datei wurde von einer neueren Version dieses Programms geschrieben.</translation>
    </message>
    <message>
        <source>A value is outside what is possible.</source>
        <translation>Ein Wert liegt außerhalb des Möglichen.</translation>
    </message>
    <message>
        <source>There is nothing of use in the file.</source>
        <translation>In der Datei ist nichts Brauchbares.</translation>
    </message>
    <message>
        <source>The computation could not be carried out.</source>
        <translation>Die Berechnung war nicht durchführbar.</translation>
    </message>
    <message>
        <source>The device is not available.</source>
        <translation>Das Gerät ist nicht verfügbar.</translation>
    </message>
    <message>
        <source>The task was cancelled.</source>
        <translation>Die Aufgabe wurde abgebrochen.</translation>
    </message>
    <message>
        <source>An internal error occurred.</source>
        <translation>Ein interner Fehler ist aufgetreten.</translation>
    </message>
    <message>
        <source>There is not enough memory.</source>
        <translation>Der Arbeitsspeicher reicht nicht.</translation>
    </message>
</context>
<context>
    <name>esm::GizmoPainter</name>
    <message>
        <source>Move the region in the plane of the screen</source>
        <translation>Die Region in der Bildebene verschieben</translation>
    </message>
    <message>
        <source>Move the region along its axis %1</source>
        <translation>Die Region entlang ihrer Achse %1 verschieben</translation>
    </message>
    <message>
        <source>Turn the region about its axis %1</source>
        <translation>Die Region um ihre Achse %1 drehen</translation>
    </message>
    <message>
        <source>Change the semi-axis %1; with Shift all of them</source>
        <translation>Die Halbachse %1 ändern; mit Umschalt alle</translation>
    </message>
    <message>
        <source>Change the falloff: from here the weight falls</source>
        <translation>Den Übergang ändern: von hier an fällt das Gewicht</translation>
    </message>
    <message>
        <source>Region: drag a handle to move, turn or resize it; beside them, dragging turns the view</source>
        <translation>Region: an einem Griff verschieben, drehen oder Größe ändern; daneben dreht Ziehen die Ansicht</translation>
    </message>
    <message>
        <source>Centre %1 · %2 · %3 mm, moved by %4 mm; Esc takes it back</source>
        <translation>Mitte %1 · %2 · %3 mm, um %4 mm verschoben; Esc nimmt es zurück</translation>
    </message>
    <message>
        <source>Turned by %1° about the axis %2; Esc takes it back</source>
        <translation>Um %1° um die Achse %2 gedreht; Esc nimmt es zurück</translation>
    </message>
    <message>
        <source>Semi-axes %1 · %2 · %3 mm; Esc takes it back</source>
        <translation>Halbachsen %1 · %2 · %3 mm; Esc nimmt es zurück</translation>
    </message>
    <message>
        <source>Falloff %1 %; Esc takes it back</source>
        <translation>Übergang %1 %; Esc nimmt es zurück</translation>
    </message>
</context>
<context>
    <name>esm::GlProbe</name>
    <message>
        <source>it is switched off by ESM_VIEW=off</source>
        <translation>sie ist durch ESM_VIEW=off abgeschaltet</translation>
    </message>
    <message>
        <source>the display "%1" has no OpenGL</source>
        <translation>die Anzeige „%1“ hat kein OpenGL</translation>
    </message>
    <message>
        <source>the graphics driver offers no OpenGL context</source>
        <translation>der Grafiktreiber bietet keinen OpenGL-Kontext</translation>
    </message>
    <message>
        <source>the graphics driver offers OpenGL %1.%2 only</source>
        <translation>der Grafiktreiber bietet nur OpenGL %1.%2</translation>
    </message>
</context>
<context>
    <name>esm::HapticDevices</name>
    <message>
        <source>no permission</source>
        <translation>keine Berechtigung</translation>
    </message>
    <message>
        <source>cannot be used</source>
        <translation>nicht benutzbar</translation>
    </message>
    <message>
        <source>ready to connect</source>
        <translation>bereit zum Verbinden</translation>
    </message>
    <message>
        <source>needs your consent</source>
        <translation>braucht deine Zustimmung</translation>
    </message>
    <message>
        <source>Axes that do not know their place yet: %1</source>
        <translation>Achsen, die ihre Lage noch nicht kennen: %1</translation>
    </message>
    <message>
        <source>Being opened…</source>
        <translation>Wird geöffnet …</translation>
    </message>
    <message>
        <source>No firmware file is chosen</source>
        <translation>Keine Firmware-Datei gewählt</translation>
    </message>
    <message>
        <source>Disconnect</source>
        <translation>Trennen</translation>
    </message>
    <message>
        <source>Connect</source>
        <translation>Verbinden</translation>
    </message>
    <message>
        <source>Firmware of your Falcon</source>
        <translation>Firmware deines Falcon</translation>
    </message>
    <message>
        <source>Firmware (*.bin *.hex *.img)</source>
        <translation>Firmware (*.bin *.hex *.img)</translation>
    </message>
    <message>
        <source>All files (*)</source>
        <translation>Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Haptic devices and their state</source>
        <translation>Haptische Geräte und ihr Zustand</translation>
    </message>
    <message>
        <source>This line in /etc/udev/rules.d/70-esm-haptics.rules permits it; then plug it out and in</source>
        <translation>Diese Zeile in /etc/udev/rules.d/70-esm-haptics.rules erlaubt es; danach aus- und einstecken</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>Kopieren</translation>
    </message>
    <message>
        <source>Copy the udev line</source>
        <translation>Die udev-Zeile kopieren</translation>
    </message>
    <message>
        <source>Search again</source>
        <translation>Neu suchen</translation>
    </message>
    <message>
        <source>Look for devices again</source>
        <translation>Erneut nach Geräten suchen</translation>
    </message>
    <message>
        <source>It is a WoodenHaptics</source>
        <translation>Es ist ein WoodenHaptics</translation>
    </message>
    <message>
        <source>Its USB numbers are nobody's own: say that what carries them is a WoodenHaptics. Holds until the program ends.</source>
        <translation>Seine USB-Nummern gehören niemandem: Sage, dass das Gerät damit ein WoodenHaptics ist. Gilt, bis das Programm endet.</translation>
    </message>
    <message>
        <source>Connect or disconnect the device; no force flows by this</source>
        <translation>Das Gerät verbinden oder trennen; dadurch fließt keine Kraft</translation>
    </message>
    <message>
        <source>Home</source>
        <translation>Grundstellung</translation>
    </message>
    <message>
        <source>The grip is at its home position now</source>
        <translation>Der Griff ist jetzt in seiner Grundstellung</translation>
    </message>
    <message>
        <source>Place on model</source>
        <translation>Auf Modell legen</translation>
    </message>
    <message>
        <source>Put the middle of the workspace into the middle of the model</source>
        <translation>Die Mitte des Arbeitsraums in die Mitte des Modells legen</translation>
    </message>
    <message>
        <source>Calibrate…</source>
        <translation>Kalibrieren …</translation>
    </message>
    <message>
        <source>Choose firmware…</source>
        <translation>Firmware wählen …</translation>
    </message>
    <message>
        <source>The Falcon forgets its firmware with each power-off; its licence forbids us to bring it</source>
        <translation>Der Falcon vergisst seine Firmware mit jedem Ausschalten; ihre Lizenz verbietet uns, sie mitzuliefern</translation>
    </message>
    <message>
        <source>Say how many newtons the device gives at 100 %, which way it pushes, and where its zero is</source>
        <translation>Angeben, wie viel Newton das Gerät bei 100 % gibt, wohin es drückt und wo sein Nullpunkt liegt</translation>
    </message>
</context>
<context>
    <name>esm::HapticPath</name>
    <message>
        <source>End recording</source>
        <translation>Aufnahme beenden</translation>
    </message>
    <message>
        <source>Record</source>
        <translation>Aufnehmen</translation>
    </message>
    <message>
        <source>Recording: %1 s</source>
        <translation>Aufnahme läuft: %1 s</translation>
    </message>
    <message>
        <source>Nothing is recorded yet.</source>
        <translation>Noch nichts aufgenommen.</translation>
    </message>
    <message>
        <source>Recorded: %1 s, largest force %2 N</source>
        <translation>Aufgenommen: %1 s, größte Kraft %2 N</translation>
    </message>
    <message>
        <source>Lead the hand</source>
        <translation>Hand führen</translation>
    </message>
    <message>
        <source>Connect the path's hand</source>
        <translation>Hand des Wegs verbinden</translation>
    </message>
    <message>
        <source>%1: %2 s, %3 points</source>
        <translation>%1: %2 s, %3 Punkte</translation>
    </message>
    <message>
        <source>No path is loaded.</source>
        <translation>Kein Weg geladen.</translation>
    </message>
    <message>
        <source>Save the path of the hand</source>
        <translation>Weg der Hand speichern</translation>
    </message>
    <message>
        <source>Save what the hand felt</source>
        <translation>Speichern, was die Hand fühlte</translation>
    </message>
    <message>
        <source>hand.csv</source>
        <translation>hand.csv</translation>
    </message>
    <message>
        <source>felt.csv</source>
        <translation>gefuehlt.csv</translation>
    </message>
    <message>
        <source>Tables (*.csv)</source>
        <translation>Tabellen (*.csv)</translation>
    </message>
    <message>
        <source>Path of a hand</source>
        <translation>Weg einer Hand</translation>
    </message>
    <message>
        <source>All files (*)</source>
        <translation>Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Record the way of the hand and what it feels, ten minutes at most</source>
        <translation>Den Weg der Hand und was sie fühlt aufnehmen, höchstens zehn Minuten</translation>
    </message>
    <message>
        <source>Save path…</source>
        <translation>Weg speichern …</translation>
    </message>
    <message>
        <source>Save the way of the hand: t, x, y, z in s and m</source>
        <translation>Den Weg der Hand speichern: t, x, y, z in s und m</translation>
    </message>
    <message>
        <source>Save log…</source>
        <translation>Protokoll speichern …</translation>
    </message>
    <message>
        <source>Save what the hand felt, tick by tick: position, velocity, force, work, lateness</source>
        <translation>Speichern, was die Hand fühlte, Takt für Takt: Lage, Geschwindigkeit, Kraft, Arbeit, Verspätung</translation>
    </message>
    <message>
        <source>Load path…</source>
        <translation>Weg laden …</translation>
    </message>
    <message>
        <source>Load the way of a hand</source>
        <translation>Den Weg einer Hand laden</translation>
    </message>
    <message>
        <source>Let the loaded path lead the hand of a device in the computer</source>
        <translation>Den geladenen Weg die Hand eines Geräts im Rechner führen lassen</translation>
    </message>
    <message>
        <source>A recording that was not saved is in %1</source>
        <translation>Eine Aufzeichnung, die nicht gespeichert wurde, liegt in %1</translation>
    </message>
</context>
<context>
    <name>esm::HapticText</name>
    <message>
        <source>The device does not know its position yet; move its grip out and in once</source>
        <translation>Das Gerät kennt seine Lage noch nicht; den Griff einmal heraus- und hineinbewegen</translation>
    </message>
    <message>
        <source>Force waits until it would begin below 0.2 N; move the tool away from the tissue</source>
        <translation>Die Kraft wartet, bis sie unter 0,2 N beginnen würde; das Werkzeug vom Gewebe wegbewegen</translation>
    </message>
    <message>
        <source>Stopped by the user; arm again to go on</source>
        <translation>Vom Benutzer gestoppt; zum Weitermachen die Kraft wieder einschalten</translation>
    </message>
    <message>
        <source>The simulation sent a force that is not a number; reset it, then arm again</source>
        <translation>Die Simulation hat eine Kraft geschickt, die keine Zahl ist; zurücksetzen, dann die Kraft wieder einschalten</translation>
    </message>
    <message>
        <source>The force gave the hand more energy than the tissue holds; lower the gain or the stiffness, then arm again</source>
        <translation>Die Kraft gab der Hand mehr Energie, als im Gewebe steckt; Verstärkung oder Steifigkeit senken, dann die Kraft wieder einschalten</translation>
    </message>
    <message>
        <source>The device does not reply; check its cable, then arm again</source>
        <translation>Das Gerät antwortet nicht; das Kabel prüfen, dann die Kraft wieder einschalten</translation>
    </message>
    <message>
        <source>The device was unplugged; connect it and open it again</source>
        <translation>Das Gerät wurde abgezogen; anstecken und neu verbinden</translation>
    </message>
    <message>
        <source>The device is closed</source>
        <translation>Das Gerät ist geschlossen</translation>
    </message>
    <message>
        <source>Asking the device whether it runs already</source>
        <translation>Das Gerät wird gefragt, ob es schon läuft</translation>
    </message>
    <message>
        <source>Uploading the firmware</source>
        <translation>Die Firmware wird übertragen</translation>
    </message>
    <message>
        <source>Pull the grip all the way out, then push it all the way in</source>
        <translation>Den Griff ganz herausziehen, dann ganz hineinschieben</translation>
    </message>
    <message>
        <source>Put the grip to its home position, then press Home</source>
        <translation>Den Griff in seine Grundstellung bringen, dann „Grundstellung“ drücken</translation>
    </message>
    <message>
        <source>The device was unplugged</source>
        <translation>Das Gerät wurde abgezogen</translation>
    </message>
    <message>
        <source>The device refuses its serial settings; plug it out and in again</source>
        <translation>Das Gerät lehnt die seriellen Einstellungen ab; aus- und wieder einstecken</translation>
    </message>
    <message>
        <source>The device took its firmware but does not answer; plug it out and in again</source>
        <translation>Das Gerät hat die Firmware genommen, antwortet aber nicht; aus- und wieder einstecken</translation>
    </message>
    <message>
        <source>The device needs its firmware: name the file of it in the settings of the device</source>
        <translation>Das Gerät braucht seine Firmware: die Datei dazu beim Gerät wählen</translation>
    </message>
    <message>
        <source>The device does not take the firmware; switch it off and on, and check the file</source>
        <translation>Das Gerät nimmt die Firmware nicht; aus- und einschalten und die Datei prüfen</translation>
    </message>
    <message>
        <source>Reading what the device can do</source>
        <translation>Das Gerät wird gefragt, was es kann</translation>
    </message>
    <message>
        <source>The device does not describe its reports</source>
        <translation>Das Gerät beschreibt seine Berichte nicht</translation>
    </message>
    <message>
        <source>The device describes its reports in a way that makes no sense</source>
        <translation>Das Gerät beschreibt seine Berichte so, dass es keinen Sinn ergibt</translation>
    </message>
    <message>
        <source>The device has no constant force that a program can set</source>
        <translation>Das Gerät hat keine konstante Kraft, die ein Programm setzen kann</translation>
    </message>
    <message>
        <source>The device does not take a force effect</source>
        <translation>Das Gerät nimmt keinen Krafteffekt an</translation>
    </message>
    <message>
        <source>Looking for it</source>
        <translation>Wird gesucht</translation>
    </message>
    <message>
        <source>Not plugged in</source>
        <translation>Nicht angesteckt</translation>
    </message>
    <message>
        <source>No %1 is plugged in</source>
        <translation>Es ist kein Gerät „%1“ angesteckt</translation>
    </message>
    <message>
        <source>You are not permitted to use it; the udev rule permits it</source>
        <translation>Du darfst es nicht benutzen; die udev-Zeile erlaubt es</translation>
    </message>
    <message>
        <source>You are not permitted to use the device; this udev rule permits it: %1</source>
        <translation>Du darfst das Gerät nicht benutzen; diese udev-Zeile erlaubt es: %1</translation>
    </message>
    <message>
        <source>The USB device %1 may not be used by you; put this line into %2 and plug the device out and in: %3</source>
        <translation>Das USB-Gerät %1 darfst du nicht benutzen; diese Zeile in %2 eintragen und das Gerät aus- und einstecken: %3</translation>
    </message>
    <message>
        <source>The USB device %1 is in use by another program; close that one</source>
        <translation>Das USB-Gerät %1 wird von einem anderen Programm benutzt; jenes schließen</translation>
    </message>
    <message>
        <source>The USB device %1 cannot be opened: %2</source>
        <translation>Das USB-Gerät %1 lässt sich nicht öffnen: %2</translation>
    </message>
    <message>
        <source>The device is no longer plugged in</source>
        <translation>Das Gerät ist nicht mehr angesteckt</translation>
    </message>
    <message>
        <source>USB cannot be used here: %1</source>
        <translation>USB ist hier nicht verfügbar: %1</translation>
    </message>
    <message>
        <source>Its USB numbers belong to nobody, so another device may carry them; confirm that it is a %1</source>
        <translation>Seine USB-Nummern gehören niemandem, ein anderes Gerät kann sie auch tragen; bestätige, dass es ein %1 ist</translation>
    </message>
    <message>
        <source>Firmware %1, SHA-256 %2</source>
        <translation>Firmware %1, SHA-256 %2</translation>
    </message>
    <message>
        <source>%1 holds %2 bytes; a firmware image has 1 to %3</source>
        <translation>%1 hat %2 Bytes; eine Firmware hat 1 bis %3</translation>
    </message>
    <message>
        <source>A device in the computer, led by the mouse</source>
        <translation>Ein Gerät im Rechner, mit der Maus geführt</translation>
    </message>
    <message>
        <source>An instrument through a trocar in the computer, led by the mouse</source>
        <translation>Ein Instrument durch einen Trokar im Rechner, mit der Maus geführt</translation>
    </message>
    <message>
        <source>Novint Falcon (USB); needs your firmware file</source>
        <translation>Novint Falcon (USB); braucht deine Firmware-Datei</translation>
    </message>
    <message>
        <source>Force-feedback stick or wheel (USB HID PID)</source>
        <translation>Force-Feedback-Joystick oder -Lenkrad (USB HID PID)</translation>
    </message>
    <message>
        <source>WoodenHaptics (USB)</source>
        <translation>WoodenHaptics (USB)</translation>
    </message>
    <message>
        <source>no device</source>
        <translation>kein Gerät</translation>
    </message>
    <message>
        <source>ready, force off</source>
        <translation>bereit, Kraft aus</translation>
    </message>
    <message>
        <source>force fades in</source>
        <translation>Kraft wird eingeblendet</translation>
    </message>
    <message>
        <source>force on</source>
        <translation>Kraft an</translation>
    </message>
    <message>
        <source>force fades out</source>
        <translation>Kraft wird ausgeblendet</translation>
    </message>
    <message>
        <source>stopped, force off</source>
        <translation>gestoppt, Kraft aus</translation>
    </message>
    <message>
        <source>is being opened</source>
        <translation>wird geöffnet</translation>
    </message>
    <message>
        <source>takes its firmware</source>
        <translation>bekommt seine Firmware</translation>
    </message>
    <message>
        <source>needs home</source>
        <translation>braucht Grundstellung</translation>
    </message>
    <message>
        <source>connected</source>
        <translation>verbunden</translation>
    </message>
    <message>
        <source>fault</source>
        <translation>Störung</translation>
    </message>
    <message>
        <source>unplugged</source>
        <translation>abgezogen</translation>
    </message>
    <message>
        <source>Simulated device</source>
        <translation>Simuliertes Gerät</translation>
    </message>
    <message>
        <source>Laparoscope</source>
        <translation>Laparoskop</translation>
    </message>
    <message>
        <source>Novint Falcon</source>
        <translation>Novint Falcon</translation>
    </message>
    <message>
        <source>Stick or wheel</source>
        <translation>Joystick oder Lenkrad</translation>
    </message>
    <message>
        <source>WoodenHaptics</source>
        <translation>WoodenHaptics</translation>
    </message>
    <message>
        <source>Hand path</source>
        <translation>Handweg</translation>
    </message>
    <message>
        <source>real-time priority</source>
        <translation>Echtzeit-Priorität</translation>
    </message>
    <message>
        <source>raised priority</source>
        <translation>erhöhte Priorität</translation>
    </message>
    <message>
        <source>normal priority</source>
        <translation>normale Priorität</translation>
    </message>
    <message>
        <source>No tissue moves: there is no model, or the simulation is paused</source>
        <translation>Kein Gewebe bewegt sich: Es gibt kein Modell, oder die Simulation ist angehalten</translation>
    </message>
    <message>
        <source>Nothing is touched or held</source>
        <translation>Nichts wird berührt oder gehalten</translation>
    </message>
    <message>
        <source>The simulation answers late: the force goes on by its last answer; a model with fewer nodes or a larger allowed error helps</source>
        <translation>Die Simulation antwortet spät: Die Kraft folgt ihrer letzten Antwort weiter; ein Modell mit weniger Knoten oder ein größerer erlaubter Fehler hilft</translation>
    </message>
    <message>
        <source>The simulation answers too late to be felt: the scene is too heavy for this computer; a model with fewer nodes or a larger allowed error helps; force comes back after five answers in time</source>
        <translation>Die Simulation antwortet zu spät, um gefühlt zu werden: Die Szene ist zu schwer für diesen Rechner; ein Modell mit weniger Knoten oder ein größerer erlaubter Fehler hilft; die Kraft kommt nach fünf rechtzeitigen Antworten wieder</translation>
    </message>
</context>
<context>
    <name>esm::HapticsPanel</name>
    <message>
        <source>%1 N</source>
        <translation>%1 N</translation>
    </message>
    <message>
        <source>Force limit</source>
        <translation>Kraftgrenze</translation>
    </message>
    <message>
        <source>Force on</source>
        <translation>Kraft an</translation>
    </message>
    <message>
        <source>Let the device feel the force; it fades in</source>
        <translation>Das Gerät die Kraft spüren lassen; sie blendet sich ein</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Stopp</translation>
    </message>
    <message>
        <source>Force in the hand</source>
        <translation>Kraft in der Hand</translation>
    </message>
    <message>
        <source>Force that a device would feel</source>
        <translation>Kraft, die ein Gerät spüren würde</translation>
    </message>
    <message>
        <source>Direction of the force: x to the right, z up, bar: y; the number is the force at the rim</source>
        <translation>Richtung der Kraft: x nach rechts, z nach oben, Balken: y; die Zahl ist die Kraft am Rand</translation>
    </message>
    <message>
        <source>%1 Hz, %2; late by %3 ms (half), %4 ms (99 %), %5 ms (99.9 %), %6 ms (worst); %7 of %8 ticks missed</source>
        <translation>%1 Hz, %2; verspätet um %3 ms (Hälfte), %4 ms (99 %), %5 ms (99,9 %), %6 ms (schlimmster); %7 von %8 Takten versäumt</translation>
    </message>
    <message>
        <source>Largest force that pull tool and device may give, in N; never above the device's own</source>
        <translation>Größte Kraft von Ziehwerkzeug und Gerät in N; nie über der des Geräts</translation>
    </message>
    <message>
        <source>Grip</source>
        <translation>Griff</translation>
    </message>
    <message>
        <source>Radius of the patch that the pull tool takes hold of, in mm; at 0 mm one node alone</source>
        <translation>Radius der Stelle, die das Ziehwerkzeug fasst, in mm; bei 0 mm ein Knoten allein</translation>
    </message>
    <message>
        <source>Gain</source>
        <translation>Verstärkung</translation>
    </message>
    <message>
        <source>Force felt over force of the tissue</source>
        <translation>Gefühlte Kraft durch Kraft des Gewebes</translation>
    </message>
    <message>
        <source>Force zero at once (Esc, and space while force is on)</source>
        <translation>Kraft sofort null (Esc; Leertaste, solange die Kraft an ist)</translation>
    </message>
    <message>
        <source>Devices</source>
        <translation>Geräte</translation>
    </message>
    <message>
        <source>Force</source>
        <translation>Kraft</translation>
    </message>
    <message>
        <source>Position</source>
        <translation>Lage</translation>
    </message>
    <message>
        <source>Energy</source>
        <translation>Energie</translation>
    </message>
    <message>
        <source>Timing</source>
        <translation>Takt</translation>
    </message>
    <message>
        <source>Path</source>
        <translation>Weg</translation>
    </message>
    <message>
        <source>Emulator</source>
        <translation>Emulator</translation>
    </message>
    <message>
        <source>Parts of the haptics panel</source>
        <translation>Teile des Haptik-Bereichs</translation>
    </message>
</context>
<context>
    <name>esm::ImportDialog</name>
    <message>
        <source>Import %1</source>
        <translation>%1 importieren</translation>
    </message>
    <message>
        <source>Report on the mesh</source>
        <translation>Bericht über das Netz</translation>
    </message>
    <message>
        <source>Count</source>
        <translation>Anzahl</translation>
    </message>
    <message>
        <source>Notes of the importer</source>
        <translation>Hinweise zum Import</translation>
    </message>
    <message>
        <source>Size of the model</source>
        <translation>Größe des Modells</translation>
    </message>
    <message>
        <source>Net that will come of it</source>
        <translation>Netz, das daraus entsteht</translation>
    </message>
    <message>
        <source>Replace the model</source>
        <translation>Modell ersetzen</translation>
    </message>
    <message>
        <source>Add to the model</source>
        <translation>Zum Modell hinzufügen</translation>
    </message>
    <message>
        <source>Message</source>
        <translation>Meldung</translation>
    </message>
    <message>
        <source>Import</source>
        <translation>Importieren</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Format</source>
        <translation>Format</translation>
    </message>
    <message>
        <source>Vertices</source>
        <translation>Punkte</translation>
    </message>
    <message>
        <source>Triangles</source>
        <translation>Dreiecke</translation>
    </message>
    <message>
        <source>Line segments</source>
        <translation>Liniensegmente</translation>
    </message>
    <message>
        <source>Connected parts</source>
        <translation>Zusammenhängende Teile</translation>
    </message>
    <message>
        <source>Boundary edges</source>
        <translation>Randkanten</translation>
    </message>
    <message>
        <source>Non-manifold edges</source>
        <translation>Mehrfach belegte Kanten</translation>
    </message>
    <message>
        <source>Degenerate triangles</source>
        <translation>Entartete Dreiecke</translation>
    </message>
    <message>
        <source>Duplicate triangles</source>
        <translation>Doppelte Dreiecke</translation>
    </message>
    <message>
        <source>Isolated vertices</source>
        <translation>Einzelne Punkte</translation>
    </message>
    <message>
        <source>Vertices without a place (NaN)</source>
        <translation>Punkte ohne Ort (NaN)</translation>
    </message>
    <message>
        <source>%1 nodes, %2 springs</source>
        <translation>%1 Knoten, %2 Federn</translation>
    </message>
    <message>
        <source>%1 × %2 × %3 mm</source>
        <translation>%1 × %2 × %3 mm</translation>
    </message>
    <message>
        <source>Not the size of an organ: is the unit right?</source>
        <translation>Nicht die Größe eines Organs: Stimmt die Einheit?</translation>
    </message>
    <message>
        <source>; about %1 MB of memory</source>
        <translation>; etwa %1 MB Speicher</translation>
    </message>
    <message>
        <source>; time step %1 ms, explicit steps then reach about %2 times real time on one core</source>
        <translation>; Zeitschritt %1 ms, explizite Schritte erreichen damit etwa das %2-Fache der Echtzeit auf einem Kern</translation>
    </message>
    <message numerus="yes">
        <source>Import %1 and %n more file(s)</source>
        <translation>
            <numerusform>%1 und %n weitere Datei importieren</numerusform>
            <numerusform>%1 und %n weitere Dateien importieren</numerusform>
        </translation>
    </message>
    <message>
        <source>File</source>
        <translation>Datei</translation>
    </message>
    <message>
        <source>Repaired</source>
        <translation>Repariert</translation>
    </message>
    <message>
        <source>Progress</source>
        <translation>Fortschritt</translation>
    </message>
    <message>
        <source>Reset</source>
        <translation>Zurücksetzen</translation>
    </message>
    <message>
        <source>Choices as for the last %1 file</source>
        <translation>Einstellungen wie bei der letzten %1-Datei</translation>
    </message>
    <message>
        <source>Forget the choices for files of this kind</source>
        <translation>Die Einstellungen für Dateien dieser Art vergessen</translation>
    </message>
    <message>
        <source>Remembered choices</source>
        <translation>Gemerkte Einstellungen</translation>
    </message>
    <message>
        <source>The net carries load: a poke of %1 N dents it by %2 mm.</source>
        <translation>Das Netz trägt: Ein Druck von %1 N dellt es um %2 mm ein.</translation>
    </message>
    <message>
        <source>The net is soft: a poke of %1 N dents it by %2 mm.</source>
        <translation>Das Netz ist weich: Ein Druck von %1 N dellt es um %2 mm ein.</translation>
    </message>
    <message>
        <source>The net collapses: a poke of %1 N moves it by more than its size.</source>
        <translation>Das Netz fällt zusammen: Ein Druck von %1 N verschiebt es um mehr als seine Größe.</translation>
    </message>
    <message>
        <source>Nothing is inside the surface: it gives way like a bag. Choose a support.</source>
        <translation>Unter der Oberfläche ist nichts: Sie gibt nach wie ein Beutel. Wähle eine Stütze.</translation>
    </message>
    <message numerus="yes">
        <source>%n motion(s) of the net that no spring resists</source>
        <translation>
            <numerusform>%n Bewegung des Netzes, der keine Feder widersteht</numerusform>
            <numerusform>%n Bewegungen des Netzes, denen keine Feder widersteht</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n node(s) that nothing holds across the plane of their springs</source>
        <translation>
            <numerusform>%n Knoten, den quer zur Ebene seiner Federn nichts hält</numerusform>
            <numerusform>%n Knoten, die quer zur Ebene ihrer Federn nichts hält</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n node(s) at which parts hang together alone</source>
        <translation>
            <numerusform>%n Knoten, an dem allein Teile zusammenhängen</numerusform>
            <numerusform>%n Knoten, an denen allein Teile zusammenhängen</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n node(s) of lines along which parts hang together alone</source>
        <translation>
            <numerusform>%n Knoten von Linien, an denen allein Teile zusammenhängen</numerusform>
            <numerusform>%n Knoten von Linien, an denen allein Teile zusammenhängen</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n part(s) that neither bands nor held nodes hold</source>
        <translation>
            <numerusform>%n Teil, den weder Bänder noch gehaltene Knoten halten</numerusform>
            <numerusform>%n Teile, die weder Bänder noch gehaltene Knoten halten</numerusform>
        </translation>
    </message>
    <message>
        <source>The net is too large to be judged before it runs.</source>
        <translation>Das Netz ist zu groß, um es vor dem Lauf zu beurteilen.</translation>
    </message>
    <message>
        <source>Gravity stays; loads on single nodes go with the former model</source>
        <translation>Die Schwerkraft bleibt; Lasten an einzelnen Knoten gehen mit dem früheren Modell</translation>
    </message>
    <message>
        <source>What stays of its tissue</source>
        <translation>Was von seinem Gewebe bleibt</translation>
    </message>
    <message>
        <source>rules and base tissue</source>
        <translation>Regeln und Grundgewebe</translation>
    </message>
    <message>
        <source>rules, base tissue and regions</source>
        <translation>Regeln, Grundgewebe und Regionen</translation>
    </message>
    <message>
        <source>nothing: the default tissue</source>
        <translation>nichts: das Standardgewebe</translation>
    </message>
    <message>
        <source>Regions lie where the former organ was</source>
        <translation>Regionen liegen dort, wo das frühere Organ war</translation>
    </message>
    <message>
        <source>With the unit %1 it would be %2 large.</source>
        <translation>Mit der Einheit %1 wäre es %2 groß.</translation>
    </message>
    <message>
        <source>The model is %1 large. Is its unit right?</source>
        <translation>Das Modell ist %1 groß. Stimmt seine Einheit?</translation>
    </message>
    <message>
        <source>Take the unit %1</source>
        <translation>Einheit %1 nehmen</translation>
    </message>
    <message>
        <source>Import as it is</source>
        <translation>So importieren</translation>
    </message>
</context>
<context>
    <name>esm::InputRow</name>
    <message>
        <source>%1 Is ‘%2’ meant?</source>
        <translation>%1 Ist „%2“ gemeint?</translation>
    </message>
    <message>
        <source>The value must lie between %1 and %2.</source>
        <translation>Der Wert muss zwischen %1 und %2 liegen.</translation>
    </message>
    <message>
        <source>%1, slider</source>
        <translation>%1, Schieberegler</translation>
    </message>
    <message>
        <source>%1, number</source>
        <translation>%1, Zahl</translation>
    </message>
    <message>
        <source>%1, word</source>
        <translation>%1, Wort</translation>
    </message>
    <message>
        <source>Type a number or a word, for instance ‘%1’.</source>
        <translation>Eine Zahl oder ein Wort eingeben, zum Beispiel „%1“.</translation>
    </message>
    <message>
        <source>Reset %1 to its default</source>
        <translation>%1 auf die Voreinstellung zurücksetzen</translation>
    </message>
</context>
<context>
    <name>esm::InputsPanel</name>
    <message>
        <source>Tissue: %1</source>
        <translation>Gewebe: %1</translation>
    </message>
    <message>
        <source>No rule fires: this is the default.</source>
        <translation>Keine Regel feuert: Das ist die Voreinstellung.</translation>
    </message>
    <message>
        <source>Result</source>
        <translation>Ergebnis</translation>
    </message>
    <message>
        <source>Deflection under 1 N</source>
        <translation>Eindrückung bei 1 N</translation>
    </message>
    <message>
        <source>How far a flat round probe of 10 mm goes into thick tissue that is held in place.</source>
        <translation>Wie weit ein flacher runder Stempel von 10 mm in dickes, gehaltenes Gewebe eindringt.</translation>
    </message>
</context>
<context>
    <name>esm::JitterPlot</name>
    <message>
        <source>lateness [ms]</source>
        <translation>Verspätung [ms]</translation>
    </message>
    <message>
        <source>ticks</source>
        <translation>Takte</translation>
    </message>
    <message>
        <source>How late the ticks of the force loop began</source>
        <translation>Wie verspätet die Takte der Kraftschleife begannen</translation>
    </message>
</context>
<context>
    <name>esm::MainWindow</name>
    <message>
        <source>“%1” opens in a window of its own.</source>
        <translation>„%1“ öffnet sich in einem eigenen Fenster.</translation>
    </message>
    <message>
        <source>“%1” is not open: this window shows the recovered work.</source>
        <translation>„%1“ ist nicht offen: Dieses Fenster zeigt die wiederhergestellte Arbeit.</translation>
    </message>
    <message>
        <source>Another window could not be started. Opening it here asks first whether to save.</source>
        <translation>Ein weiteres Fenster ließ sich nicht starten. Wer die Datei hier öffnet, wird erst gefragt, ob zu speichern ist.</translation>
    </message>
    <message>
        <source>&amp;Open here</source>
        <translation>Hier ö&amp;ffnen</translation>
    </message>
    <message>
        <source>%1[*] – Elastodynamic Shape Modeler</source>
        <translation>%1[*] – Elastodynamic Shape Modeler</translation>
    </message>
    <message>
        <source>%1. The version that was there stays as “%2”.</source>
        <translation>%1. Die Fassung, die dort stand, bleibt als „%2“.</translation>
    </message>
    <message>
        <source>The simulation stopped on its last good state. %1</source>
        <translation>Die Simulation hielt auf dem letzten guten Stand an. %1</translation>
    </message>
    <message>
        <source>Stopped: force zero, tissue released. “Force on” lets the device feel again.</source>
        <translation>Gestoppt: Kraft null, Gewebe losgelassen. Mit „Kraft an“ spürt das Gerät wieder.</translation>
    </message>
    <message>
        <source>Stopped: the tissue is released, force is zero.</source>
        <translation>Gestoppt: Das Gewebe ist losgelassen, die Kraft ist null.</translation>
    </message>
    <message>
        <source>Force is zero, nothing is held.</source>
        <translation>Die Kraft ist null, nichts wird gehalten.</translation>
    </message>
    <message>
        <source>Regions</source>
        <translation>Regionen</translation>
    </message>
    <message>
        <source>Tissue</source>
        <translation>Gewebe</translation>
    </message>
    <message>
        <source>Fuzzy Input</source>
        <translation>Fuzzy-Eingabe</translation>
    </message>
    <message>
        <source>Why?</source>
        <translation>Warum?</translation>
    </message>
    <message>
        <source>Fuzzy Rules</source>
        <translation>Fuzzy-Regeln</translation>
    </message>
    <message>
        <source>Haptics</source>
        <translation>Haptik</translation>
    </message>
    <message>
        <source>&amp;Undo: %1</source>
        <translation>&amp;Rückgängig: %1</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Rückgängig</translation>
    </message>
    <message>
        <source>&amp;Redo: %1</source>
        <translation>&amp;Wiederholen: %1</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>&amp;Wiederholen</translation>
    </message>
    <message>
        <source>Camera: drag turns, wheel zooms</source>
        <translation>Kamera: Ziehen dreht, Rad zoomt</translation>
    </message>
    <message>
        <source>Pull: drag the tissue (Esc lets go)</source>
        <translation>Ziehen: Gewebe fassen und ziehen (Esc lässt los)</translation>
    </message>
    <message>
        <source>Select: click a node to see why it is as it is</source>
        <translation>Auswahl: Knoten anklicken, um zu sehen, warum er so ist</translation>
    </message>
    <message>
        <source>Keys</source>
        <translation>Tasten</translation>
    </message>
    <message>
        <source>In the preview: F fits, 1, 3 and 7 look from front, right and top, arrows turn, + and - zoom.</source>
        <translation>In der Vorschau: F zeigt alles, 1, 3 und 7 blicken von vorn, rechts und oben, Pfeile drehen, + und - zoomen.</translation>
    </message>
    <message>
        <source>About the Elastodynamic Shape Modeler</source>
        <translation>Über den Elastodynamic Shape Modeler</translation>
    </message>
    <message>
        <source>&lt;h3&gt;Elastodynamic Shape Modeler %1&lt;/h3&gt;&lt;p&gt;Meshes become spring-mass nets, words and rules give them their tissue, and their force can be felt.&lt;/p&gt;&lt;p&gt;Licence: GPL-3.0-or-later (core libraries: MIT)&lt;/p&gt;</source>
        <translation>&lt;h3&gt;Elastodynamic Shape Modeler %1&lt;/h3&gt;&lt;p&gt;Aus Netzen werden Feder-Masse-Netze, Wörter und Regeln geben ihnen ihr Gewebe, und ihre Kraft ist zu spüren.&lt;/p&gt;&lt;p&gt;Lizenz: GPL-3.0-or-later (Kernbibliotheken: MIT)&lt;/p&gt;</translation>
    </message>
    <message>
        <source>Open project</source>
        <translation>Projekt öffnen</translation>
    </message>
    <message>
        <source>Open sample</source>
        <translation>Beispiel öffnen</translation>
    </message>
    <message>
        <source>Projects (*.esm *.esmb)</source>
        <translation>Projekte (*.esm *.esmb)</translation>
    </message>
    <message>
        <source>All files (*)</source>
        <translation>Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Save project</source>
        <translation>Projekt speichern</translation>
    </message>
    <message>
        <source>Saved %1</source>
        <translation>%1 gespeichert</translation>
    </message>
    <message>
        <source>Projects (*.esm)</source>
        <translation>Projekte (*.esm)</translation>
    </message>
    <message>
        <source>Compact projects (*.esmb)</source>
        <translation>Kompakte Projekte (*.esmb)</translation>
    </message>
    <message>
        <source>Unsaved changes</source>
        <translation>Nicht gespeicherte Änderungen</translation>
    </message>
    <message>
        <source>“%1” has changes that are not saved.</source>
        <translation>„%1“ hat Änderungen, die nicht gespeichert sind.</translation>
    </message>
    <message>
        <source>Save them?</source>
        <translation>Sollen sie gespeichert werden?</translation>
    </message>
    <message>
        <source>There is no model to export.</source>
        <translation>Es gibt kein Modell zum Exportieren.</translation>
    </message>
    <message>
        <source>Export shape</source>
        <translation>Form exportieren</translation>
    </message>
    <message>
        <source>Exported %1</source>
        <translation>%1 exportiert</translation>
    </message>
    <message>
        <source>Picture of the preview</source>
        <translation>Bild der Vorschau</translation>
    </message>
    <message>
        <source>Pictures (*.png *.jpg)</source>
        <translation>Bilder (*.png *.jpg)</translation>
    </message>
    <message>
        <source>Rename project</source>
        <translation>Projekt umbenennen</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>Clear list</source>
        <translation>Liste leeren</translation>
    </message>
    <message>
        <source>Terms</source>
        <translation>Begriffe</translation>
    </message>
    <message>
        <source>Surface</source>
        <translation>Fläche</translation>
    </message>
    <message>
        <source>Region: drag its handles (Esc takes a drag back)</source>
        <translation>Region: an den Griffen ziehen (Esc nimmt es zurück)</translation>
    </message>
    <message>
        <source>Plain nets (*.json *.xsp)</source>
        <translation>Einfache Netze (*.json *.xsp)</translation>
    </message>
    <message>
        <source>OBJ with springs (*.obj);;PLY (*.ply);;STL (*.stl);;glTF binary (*.glb);;glTF text (*.gltf);;VTK (*.vtu);;Tables (*.csv);;SOFA scene (*.scn);;Masses and springs, Xsp 3.0 (*.xsp)</source>
        <translation>OBJ mit Federn (*.obj);;PLY (*.ply);;STL (*.stl);;glTF binär (*.glb);;glTF als Text (*.gltf);;VTK (*.vtu);;Tabellen (*.csv);;SOFA-Szene (*.scn);;Massen und Federn, Xsp 3.0 (*.xsp)</translation>
    </message>
    <message>
        <source>Exported %1. It does not hold: %2</source>
        <translation>%1 exportiert. Darin fehlt: %2</translation>
    </message>
    <message>
        <source>Import meshes</source>
        <translation>Netze importieren</translation>
    </message>
    <message>
        <source>Drop to open the project</source>
        <translation>Loslassen öffnet das Projekt</translation>
    </message>
    <message numerus="yes">
        <source>Drop to import %n file(s)</source>
        <translation>
            <numerusform>Loslassen importiert %n Datei</numerusform>
            <numerusform>Loslassen importiert %n Dateien</numerusform>
        </translation>
    </message>
    <message>
        <source>Meshes</source>
        <translation>Netze</translation>
    </message>
    <message>
        <source>Meshes with a reader of their own</source>
        <translation>Netze mit eigenem Leser</translation>
    </message>
    <message>
        <source>Foreign formats</source>
        <translation>Fremde Formate</translation>
    </message>
    <message>
        <source>Update the model</source>
        <translation>Modell aktualisieren</translation>
    </message>
    <message>
        <source>“%1” was changed by someone else since it was opened here.</source>
        <translation>„%1“ wurde von anderer Seite geändert, seit es hier geöffnet wurde.</translation>
    </message>
    <message>
        <source>Overwriting replaces that version by yours; it stays beside it as “%1”.</source>
        <translation>Überschreiben ersetzt jene Fassung durch die hiesige; jene bleibt daneben als „%1“.</translation>
    </message>
    <message>
        <source>“%1” holds another model, which was replaced here.</source>
        <translation>„%1“ enthält ein anderes Modell, das hier ersetzt wurde.</translation>
    </message>
    <message>
        <source>Overwriting puts the new model in its place; under another name, both stay.</source>
        <translation>Überschreiben setzt das neue Modell an seine Stelle; unter anderem Namen bleiben beide.</translation>
    </message>
    <message>
        <source>&amp;Overwrite</source>
        <translation>Ü&amp;berschreiben</translation>
    </message>
    <message>
        <source>Save &amp;as…</source>
        <translation>Speichern &amp;unter…</translation>
    </message>
    <message>
        <source>Opened %1</source>
        <translation>%1 geöffnet</translation>
    </message>
    <message>
        <source>Opened %1. The simulation is paused: the space key plays it.</source>
        <translation>%1 geöffnet. Die Simulation ist angehalten: Die Leertaste spielt sie ab.</translation>
    </message>
    <message>
        <source>The simulation is paused: nothing moves until it plays (space key).</source>
        <translation>Die Simulation ist angehalten: Es bewegt sich nichts, bis sie abgespielt wird (Leertaste).</translation>
    </message>
    <message>
        <source>Unsaved work is not kept for the case of a crash. %1 %2</source>
        <translation>Nicht gespeicherte Arbeit wird für den Fall eines Absturzes nicht aufbewahrt. %1 %2</translation>
    </message>
    <message>
        <source>Recover unsaved work</source>
        <translation>Nicht gespeicherte Arbeit wiederherstellen</translation>
    </message>
    <message>
        <source>There is nothing to recover.</source>
        <translation>Es gibt nichts wiederherzustellen.</translation>
    </message>
    <message>
        <source>Recovered: %1. Nothing of it is saved yet.</source>
        <translation>Wiederhergestellt: %1. Davon ist noch nichts gespeichert.</translation>
    </message>
    <message>
        <source>The file has changed since, or is gone: %1. What was recovered does not replace it; saving asks for a place.</source>
        <translation>Die Datei wurde seither geändert oder ist fort: %1. Das Wiederhergestellte ersetzt sie nicht; beim Speichern wird nach dem Ort gefragt.</translation>
    </message>
    <message>
        <source>The end of what was kept is damaged; recovered is what came before. The damaged lines are left beside the other journals.</source>
        <translation>Das Ende des Aufbewahrten ist beschädigt; wiederhergestellt ist, was davor steht. Die beschädigten Zeilen bleiben neben den anderen Journalen liegen.</translation>
    </message>
    <message>
        <source>A rule has a mistake. Saving leaves it out, and it will be lost.</source>
        <translation>Eine Regel hat einen Fehler. Beim Speichern bleibt sie weg und geht verloren.</translation>
    </message>
    <message>
        <source>Saved %1, but for a rule with a mistake.</source>
        <translation>%1 gespeichert, bis auf eine Regel mit einem Fehler.</translation>
    </message>
    <message>
        <source>The simulation is paused: nothing moves until “Play” is pressed.</source>
        <translation>Die Simulation ist angehalten: Es bewegt sich nichts, bis „Abspielen“ gedrückt wird.</translation>
    </message>
    <message>
        <source>The samples were not found beside the program; is it installed whole?</source>
        <translation>Die Beispiele fehlen neben dem Programm; ist es ganz installiert?</translation>
    </message>
</context>
<context>
    <name>esm::MembershipPanel</name>
    <message>
        <source>Input: %1</source>
        <translation>Eingabe: %1</translation>
    </message>
    <message>
        <source>Result: %1</source>
        <translation>Ergebnis: %1</translation>
    </message>
    <message>
        <source>Variable that the plot shows</source>
        <translation>Größe, die das Diagramm zeigt</translation>
    </message>
    <message>
        <source>Spread words evenly</source>
        <translation>Wörter gleichmäßig verteilen</translation>
    </message>
    <message>
        <source>How many words shall lie evenly over the range of %1?</source>
        <translation>Wie viele Wörter sollen gleichmäßig über dem Bereich von %1 liegen?</translation>
    </message>
    <message>
        <source>Number of words</source>
        <translation>Anzahl der Wörter</translation>
    </message>
    <message>
        <source>Sum 1</source>
        <translation>Summe 1</translation>
    </message>
    <message>
        <source>Memberships go on to sum to 1</source>
        <translation>Zugehörigkeiten behalten die Summe 1</translation>
    </message>
    <message>
        <source>Neighbouring words follow a dragged point, so that the memberships of every value go on to sum to 1. Not possible with a bell or where peaks coincide.</source>
        <translation>Benachbarte Wörter folgen einem gezogenen Punkt, sodass die Zugehörigkeiten jedes Wertes die Summe 1 behalten. Nicht möglich mit einer Glocke oder wo Spitzen zusammenfallen.</translation>
    </message>
    <message>
        <source>Spread…</source>
        <translation>Verteilen …</translation>
    </message>
    <message>
        <source>Several words at once, evenly over the range</source>
        <translation>Mehrere Wörter auf einmal, gleichmäßig über den Bereich</translation>
    </message>
</context>
<context>
    <name>esm::MembershipPlot</name>
    <message>
        <source>Plot of a variable's words</source>
        <translation>Diagramm der Wörter einer Größe</translation>
    </message>
    <message>
        <source>Plot of the words for %1</source>
        <translation>Diagramm der Wörter für %1</translation>
    </message>
    <message>
        <source>The words are: %1.</source>
        <translation>Die Wörter sind: %1.</translation>
    </message>
</context>
<context>
    <name>esm::MistakeBar</name>
    <message>
        <source>&amp;Replace by ‘%1’</source>
        <translation>Durch „%1“ &amp;ersetzen</translation>
    </message>
    <message>
        <source>Replace the marked word by ‘%1’</source>
        <translation>Das markierte Wort durch „%1“ ersetzen</translation>
    </message>
    <message>
        <source>&amp;Discard</source>
        <translation>&amp;Verwerfen</translation>
    </message>
    <message>
        <source>Discard the text that is no rule</source>
        <translation>Den Text verwerfen, der keine Regel ist</translation>
    </message>
</context>
<context>
    <name>esm::Overlay</name>
    <message>
        <source>Stiffness [N/m]</source>
        <translation>Steifigkeit [N/m]</translation>
    </message>
    <message>
        <source>Strain [%]</source>
        <translation>Dehnung [%]</translation>
    </message>
    <message>
        <source>Force [mN]</source>
        <translation>Kraft [mN]</translation>
    </message>
    <message>
        <source>%1 N</source>
        <translation>%1 N</translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
    <message>
        <source>Camera: drag to turn, right button to move, wheel to zoom, F to fit</source>
        <translation>Kamera: Ziehen dreht, rechte Taste verschiebt, Rad zoomt, F zeigt alles</translation>
    </message>
    <message>
        <source>Pull: release or Esc lets go</source>
        <translation>Ziehen: Loslassen oder Esc gibt frei</translation>
    </message>
    <message>
        <source>Pull: drag a point of the organ; beside it, dragging turns the view</source>
        <translation>Ziehen: einen Punkt des Organs fassen; daneben dreht Ziehen die Ansicht</translation>
    </message>
    <message>
        <source>Nothing to show yet: import a mesh or open a project.</source>
        <translation>Noch nichts zu sehen: ein Netz importieren oder ein Projekt öffnen.</translation>
    </message>
    <message>
        <source>Weight: choose a region</source>
        <translation>Gewicht: Region wählen</translation>
    </message>
    <message>
        <source>Weight of %1 [%]</source>
        <translation>Gewicht von %1 [%]</translation>
    </message>
    <message numerus="yes">
        <source>Select: %n node(s); Shift adds, Ctrl takes away, Esc clears</source>
        <translation>
            <numerusform>Auswahl: %n Knoten; Umschalt nimmt dazu, Strg nimmt weg, Esc leert</numerusform>
            <numerusform>Auswahl: %n Knoten; Umschalt nimmt dazu, Strg nimmt weg, Esc leert</numerusform>
        </translation>
    </message>
    <message>
        <source>Select: click a point of the organ, or drag a box around what can be seen</source>
        <translation>Auswahl: einen Punkt des Organs anklicken oder einen Kasten um Sichtbares ziehen</translation>
    </message>
    <message>
        <source>Region: choose or add one in the dock Regions</source>
        <translation>Region: im Fenster Regionen eine wählen oder hinzufügen</translation>
    </message>
    <message>
        <source>Region: locked</source>
        <translation>Region: gesperrt</translation>
    </message>
    <message>
        <source>Region: hidden</source>
        <translation>Region: verborgen</translation>
    </message>
</context>
<context>
    <name>esm::PresetBar</name>
    <message>
        <source>Preset: %1</source>
        <translation>Voreinstellung: %1</translation>
    </message>
    <message>
        <source>Reset all inputs</source>
        <translation>Alle Eingaben zurücksetzen</translation>
    </message>
    <message>
        <source>Damping ratio</source>
        <translation>Dämpfungsgrad</translation>
    </message>
    <message>
        <source>%1 (%2 to %3)</source>
        <translation>%1 (%2 bis %3)</translation>
    </message>
    <message>
        <source>%1, estimate</source>
        <translation>%1, Schätzung</translation>
    </message>
    <message>
        <source>The inputs are those of: %1</source>
        <translation>Die Eingaben sind die von: %1</translation>
    </message>
    <message>
        <source>The inputs are those of no preset.</source>
        <translation>Die Eingaben entsprechen keiner Voreinstellung.</translation>
    </message>
    <message>
        <source>Preset</source>
        <translation>Voreinstellung</translation>
    </message>
    <message>
        <source>Choose a tissue to start from</source>
        <translation>Ein Gewebe wählen, von dem ausgegangen wird</translation>
    </message>
    <message>
        <source>Sources</source>
        <translation>Quellen</translation>
    </message>
    <message>
        <source>Show what is measured of this tissue, how and by whom</source>
        <translation>Zeigen, was an diesem Gewebe gemessen ist, wie und von wem</translation>
    </message>
    <message>
        <source>Reset</source>
        <translation>Zurücksetzen</translation>
    </message>
    <message>
        <source>Reset all inputs to their defaults</source>
        <translation>Alle Eingaben auf ihre Vorgaben zurücksetzen</translation>
    </message>
    <message>
        <source>Tissues to start from</source>
        <translation>Gewebe, von denen ausgegangen werden kann</translation>
    </message>
    <message>
        <source>What is measured of this tissue</source>
        <translation>Was an diesem Gewebe gemessen ist</translation>
    </message>
</context>
<context>
    <name>esm::ProblemsModel</name>
    <message>
        <source>%1 is about %2</source>
        <translation>%1 etwa %2 ist</translation>
    </message>
    <message>
        <source> and </source>
        <translation> und </translation>
    </message>
    <message>
        <source>Gap: No rule for %1 ever fires.</source>
        <translation>Lücke: Keine Regel für %1 feuert jemals.</translation>
    </message>
    <message>
        <source>Gap: No rule speaks of %1 where %2.</source>
        <translation>Lücke: Keine Regel spricht von %1, wo %2.</translation>
    </message>
    <message>
        <source>Gap: No word of %1 fits where %2.</source>
        <translation>Lücke: Kein Wort von %1 passt, wo %2.</translation>
    </message>
    <message>
        <source>Contradiction: Rules %1 and %2 conclude differently on the same condition.</source>
        <translation>Widerspruch: Die Regeln %1 und %2 folgern Verschiedenes aus derselben Bedingung.</translation>
    </message>
    <message>
        <source>Duplicate: Rules %1 and %2 say the same.</source>
        <translation>Doppelt: Die Regeln %1 und %2 sagen dasselbe.</translation>
    </message>
    <message>
        <source>Hidden: Rule %1 never counts, because rule %2 concludes the same on a weaker condition.</source>
        <translation>Verdeckt: Regel %1 zählt nie, weil Regel %2 dasselbe aus einer schwächeren Bedingung folgert.</translation>
    </message>
    <message>
        <source>Idle: The condition of rule %1 holds nowhere.</source>
        <translation>Untätig: Die Bedingung von Regel %1 gilt nirgends.</translation>
    </message>
    <message>
        <source>Overlap: The words ‘%1’ and ‘%2’ of %3 share %4 % of their area, so that they hardly differ.</source>
        <translation>Überlappung: Die Wörter „%1“ und „%2“ von %3 teilen %4 % ihrer Fläche, sodass sie sich kaum unterscheiden.</translation>
    </message>
    <message>
        <source>Unset: No rule concludes on %1.</source>
        <translation>Ungesetzt: Keine Regel folgert auf %1.</translation>
    </message>
    <message>
        <source>Double click or Return sets the inputs to this place.</source>
        <translation>Doppelklick oder Eingabetaste stellt die Eingaben auf diese Stelle.</translation>
    </message>
    <message>
        <source>Double click or Return shows the rule.</source>
        <translation>Doppelklick oder Eingabetaste zeigt die Regel.</translation>
    </message>
    <message>
        <source>Double click or Return shows the words.</source>
        <translation>Doppelklick oder Eingabetaste zeigt die Wörter.</translation>
    </message>
</context>
<context>
    <name>esm::ProblemsView</name>
    <message>
        <source>Go to a gap in the rules</source>
        <translation>Zu einer Lücke in den Regeln gehen</translation>
    </message>
    <message numerus="yes">
        <source>%n problem(s)</source>
        <translation>
            <numerusform>%n Problem</numerusform>
            <numerusform>%n Probleme</numerusform>
        </translation>
    </message>
    <message>
        <source>Problems</source>
        <translation>Probleme</translation>
    </message>
    <message>
        <source>Problems of the rules</source>
        <translation>Probleme der Regeln</translation>
    </message>
    <message>
        <source>No problems</source>
        <translation>Keine Probleme</translation>
    </message>
    <message>
        <source>Every place has a rule, and every rule counts.</source>
        <translation>Jede Stelle hat eine Regel, und jede Regel zählt.</translation>
    </message>
</context>
<context>
    <name>esm::RealTimeDialog</name>
    <message>
        <source>Up</source>
        <translation>Nach oben</translation>
    </message>
    <message>
        <source>Down</source>
        <translation>Nach unten</translation>
    </message>
    <message>
        <source>Real time</source>
        <translation>Echtzeit</translation>
    </message>
    <message>
        <source>What gives way, the first one first</source>
        <translation>Was nachgibt, das Erste zuerst</translation>
    </message>
    <message>
        <source>Let it give way earlier</source>
        <translation>Soll früher nachgeben</translation>
    </message>
    <message>
        <source>Let it give way later</source>
        <translation>Soll später nachgeben</translation>
    </message>
    <message>
        <source>Wanted error</source>
        <translation>Gewünschter Fehler</translation>
    </message>
    <message>
        <source>Largest allowed error</source>
        <translation>Größter erlaubter Fehler</translation>
    </message>
    <message>
        <source> %</source>
        <translation> %</translation>
    </message>
    <message>
        <source>Error of the positions, as a part of the motion</source>
        <translation>Fehler der Orte, gemessen an der Bewegung</translation>
    </message>
    <message>
        <source>A model that is too heavy for this computer first gives up accuracy, then runs in slow motion. Choose the order; what stands below slow motion never gives way.</source>
        <translation>Ein Modell, das für diesen Rechner zu schwer ist, verliert zuerst Genauigkeit und läuft dann in Zeitlupe. Die Reihenfolge ist wählbar; was unter der Zeitlupe steht, gibt nie nach.</translation>
    </message>
    <message>
        <source>OK</source>
        <translation>OK</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Defaults</source>
        <translation>Vorgaben</translation>
    </message>
    <message>
        <source>Larger error, up to the allowed one</source>
        <translation>Größerer Fehler, bis zum erlaubten</translation>
    </message>
    <message>
        <source>Rougher solver steps, implicit sooner</source>
        <translation>Gröbere Löserschritte, früher implizit</translation>
    </message>
    <message>
        <source>Slow motion</source>
        <translation>Zeitlupe</translation>
    </message>
    <message>
        <source>%1. %2</source>
        <translation>%1. %2</translation>
    </message>
    <message>
        <source>never: %1</source>
        <translation>nie: %1</translation>
    </message>
</context>
<context>
    <name>esm::Reason</name>
    <message>
        <source>springs at node %1 (%2 N/m on %3 kg) need explicit steps of %4 µs</source>
        <translation>Federn am Knoten %1 (%2 N/m an %3 kg) brauchen explizite Schritte von %4 µs</translation>
    </message>
    <message>
        <source>no spring limits the step</source>
        <translation>keine Feder begrenzt den Schritt</translation>
    </message>
    <message>
        <source>%1 as asked</source>
        <translation>%1 wie gewünscht</translation>
    </message>
    <message>
        <source>explicit steps are cheapest</source>
        <translation>explizite Schritte sind am billigsten</translation>
    </message>
    <message>
        <source>the tolerance asks for order %1</source>
        <translation>die Toleranz verlangt Ordnung %1</translation>
    </message>
    <message>
        <source>the engine went implicit</source>
        <translation>es wird implizit gerechnet</translation>
    </message>
    <message>
        <source>the engine went implicit and stays bounded, but the tolerance may not hold</source>
        <translation>es wird implizit gerechnet und bleibt beschränkt, aber die Toleranz wird vielleicht nicht gehalten</translation>
    </message>
    <message>
        <source>the tolerance would cost too many steps and may not hold</source>
        <translation>die Toleranz würde zu viele Schritte kosten und wird vielleicht nicht gehalten</translation>
    </message>
    <message>
        <source>as no step was both good and affordable, it takes damped steps that gain no energy: lower the stiffness or the loads, raise the masses, or allow more effort</source>
        <translation>weil kein Schritt zugleich gut und bezahlbar war, werden gedämpfte Schritte getan, die keine Energie gewinnen: Steifigkeit oder Lasten senken, Massen erhöhen oder mehr Aufwand erlauben</translation>
    </message>
    <message>
        <source>numbers became infinite (stiffest at node %1)</source>
        <translation>Zahlen wurden unendlich (am steifsten am Knoten %1)</translation>
    </message>
    <message>
        <source>numbers became infinite</source>
        <translation>Zahlen wurden unendlich</translation>
    </message>
    <message>
        <source>the solver %1 found no step small enough (stiffest at node %2)</source>
        <translation>der Löser %1 fand keinen Schritt, der klein genug ist (am steifsten am Knoten %2)</translation>
    </message>
    <message>
        <source>the solver %1 found no step small enough</source>
        <translation>der Löser %1 fand keinen Schritt, der klein genug ist</translation>
    </message>
    <message>
        <source>the last good state is kept: take a smaller fixed step, at most %1 µs, or automatic steps</source>
        <translation>der letzte gute Stand bleibt: ein kleinerer fester Schritt, höchstens %1 µs, oder automatische Schritte helfen</translation>
    </message>
    <message>
        <source>the last good state is kept: lower the stiffness or the loads, or raise the masses</source>
        <translation>der letzte gute Stand bleibt: Steifigkeit oder Lasten senken oder Massen erhöhen</translation>
    </message>
    <message>
        <source>the last good state is kept: lower the stiffness or the loads, or take a larger tolerance</source>
        <translation>der letzte gute Stand bleibt: Steifigkeit oder Lasten senken oder eine größere Toleranz wählen</translation>
    </message>
    <message>
        <source>they take them alone, and the rest its own</source>
        <translation>sie tun sie allein, und der Rest die seinen</translation>
    </message>
    <message>
        <source>to keep time, it takes a few damped steps for each frame, whose error is told</source>
        <translation>um mit der Zeit Schritt zu halten, werden für jedes Bild wenige gedämpfte Schritte getan, deren Fehler angezeigt wird</translation>
    </message>
</context>
<context>
    <name>esm::RecipeForm</name>
    <message>
        <source>File</source>
        <translation>Datei</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>Einheit</translation>
    </message>
    <message>
        <source>Axes</source>
        <translation>Achsen</translation>
    </message>
    <message>
        <source>z up</source>
        <translation>z oben</translation>
    </message>
    <message>
        <source>y up</source>
        <translation>y oben</translation>
    </message>
    <message>
        <source>patient, LPS (DICOM)</source>
        <translation>Patient, LPS (DICOM)</translation>
    </message>
    <message>
        <source>patient, RAS (NIfTI)</source>
        <translation>Patient, RAS (NIfTI)</translation>
    </message>
    <message>
        <source>Join vertices at the same place</source>
        <translation>Eckpunkte am selben Ort verbinden</translation>
    </message>
    <message>
        <source>Weld tolerance (unit of the file)</source>
        <translation>Toleranz (Einheit der Datei)</translation>
    </message>
    <message>
        <source>Repair</source>
        <translation>Reparatur</translation>
    </message>
    <message>
        <source>Take away degenerate and duplicate triangles</source>
        <translation>Entartete und doppelte Dreiecke entfernen</translation>
    </message>
    <message>
        <source>Turn all triangles to the same side</source>
        <translation>Alle Dreiecke nach derselben Seite drehen</translation>
    </message>
    <message>
        <source>Tie vertices to edges that they lie on</source>
        <translation>Eckpunkte an Kanten binden, auf denen sie liegen</translation>
    </message>
    <message>
        <source>Drop parts below</source>
        <translation>Teile weglassen unter</translation>
    </message>
    <message>
        <source>Fill holes up to</source>
        <translation>Löcher füllen bis</translation>
    </message>
    <message>
        <source>no hole</source>
        <translation>keine Löcher</translation>
    </message>
    <message>
        <source>Net</source>
        <translation>Netz</translation>
    </message>
    <message>
        <source>Remesh to</source>
        <translation>Neu vernetzen auf</translation>
    </message>
    <message>
        <source>as it is</source>
        <translation>wie es ist</translation>
    </message>
    <message>
        <source>Polygons</source>
        <translation>Vielecke</translation>
    </message>
    <message>
        <source>edges and diagonals</source>
        <translation>Kanten und Diagonalen</translation>
    </message>
    <message>
        <source>edges only</source>
        <translation>nur Kanten</translation>
    </message>
    <message>
        <source>Support</source>
        <translation>Stütze</translation>
    </message>
    <message>
        <source>Inside</source>
        <translation>Im Inneren</translation>
    </message>
    <message>
        <source>nothing</source>
        <translation>nichts</translation>
    </message>
    <message>
        <source>struts to the opposite wall</source>
        <translation>Streben zur Gegenwand</translation>
    </message>
    <message>
        <source>wall of cells (hollow organs)</source>
        <translation>Wand aus Zellen (Hohlorgane)</translation>
    </message>
    <message>
        <source>For hollow organs and tubes. On a tube under small loads 6 % off finite elements, in a pinch 30 %; deep pinches may snap.</source>
        <translation>Für Hohlorgane und Röhren. Bei einer Röhre unter kleinen Lasten 6 % neben finiten Elementen, beim Kneifen 30 %; tiefes Kneifen kann umschnappen.</translation>
    </message>
    <message>
        <source>For thin and open bodies. Expected error against finite elements: 35 %, in a pinch more than 100 %.</source>
        <translation>Für dünne und offene Körper. Erwarteter Fehler gegen finite Elemente: 35 %, beim Kneifen mehr als 100 %.</translation>
    </message>
    <message>
        <source>For fat organs, with the fewest springs.</source>
        <translation>Für dicke Organe, mit den wenigsten Federn.</translation>
    </message>
    <message>
        <source>For fat organs, alike everywhere.</source>
        <translation>Für dicke Organe, überall gleich.</translation>
    </message>
    <message>
        <source>For closed, clean surfaces.</source>
        <translation>Für geschlossene, saubere Oberflächen.</translation>
    </message>
    <message>
        <source>The skin alone gives way like a bag. For hollow organs choose the wall.</source>
        <translation>Die Haut allein gibt nach wie ein Sack. Für Hohlorgane die Wand wählen.</translation>
    </message>
    <message>
        <source>hubs with spokes</source>
        <translation>Naben mit Speichen</translation>
    </message>
    <message>
        <source>lattice</source>
        <translation>Gitter</translation>
    </message>
    <message>
        <source>tetrahedra (tetgen or gmsh)</source>
        <translation>Tetraeder (tetgen oder gmsh)</translation>
    </message>
    <message>
        <source>Struts per node</source>
        <translation>Streben je Knoten</translation>
    </message>
    <message>
        <source>Bands to the cavity</source>
        <translation>Bänder zur Höhle</translation>
    </message>
    <message>
        <source>none</source>
        <translation>keine</translation>
    </message>
    <message>
        <source>from every node</source>
        <translation>von jedem Knoten</translation>
    </message>
    <message>
        <source>Length of the bands</source>
        <translation>Länge der Bänder</translation>
    </message>
    <message>
        <source>equal positions only</source>
        <translation>nur gleiche Orte</translation>
    </message>
    <message>
        <source> % of the largest</source>
        <translation> % des größten</translation>
    </message>
    <message>
        <source> edges</source>
        <translation> Kanten</translation>
    </message>
    <message>
        <source> triangles</source>
        <translation> Dreiecke</translation>
    </message>
    <message>
        <source>Springs of nearly equal length allow a larger time step</source>
        <translation>Fast gleich lange Federn erlauben einen größeren Zeitschritt</translation>
    </message>
    <message>
        <source>A surface alone gives way like a bag; what is inside carries the load. It can be taken away again.</source>
        <translation>Eine Oberfläche allein gibt nach wie ein Beutel; was im Inneren ist, trägt. Es lässt sich wieder entfernen.</translation>
    </message>
    <message>
        <source>Material</source>
        <translation>Material</translation>
    </message>
    <message>
        <source>Body</source>
        <translation>Körper</translation>
    </message>
    <message>
        <source>wall of tissue</source>
        <translation>Wand aus Gewebe</translation>
    </message>
    <message>
        <source>solid</source>
        <translation>massiv</translation>
    </message>
    <message>
        <source>Wall thickness</source>
        <translation>Wanddicke</translation>
    </message>
    <message>
        <source>Density</source>
        <translation>Dichte</translation>
    </message>
    <message>
        <source>Young's modulus</source>
        <translation>Elastizitätsmodul</translation>
    </message>
    <message>
        <source>Fit the springs to Young's modulus</source>
        <translation>Federn an den Elastizitätsmodul anpassen</translation>
    </message>
    <message>
        <source>as the tissue says</source>
        <translation>wie das Gewebe sagt</translation>
    </message>
    <message>
        <source>Sets the inputs of the rules, and scales all springs until the net is as stiff as the body</source>
        <translation>Stellt die Eingaben der Regeln und skaliert alle Federn, bis das Netz so steif ist wie der Körper</translation>
    </message>
    <message>
        <source>Sets the inputs of the rules</source>
        <translation>Stellt die Eingaben der Regeln</translation>
    </message>
    <message>
        <source>A virtual tension test: pulled along its longest axis the net becomes as stiff as the body</source>
        <translation>Ein virtueller Zugversuch: entlang seiner längsten Achse gezogen wird das Netz so steif wie der Körper</translation>
    </message>
    <message>
        <source>Pressure keeps the volume</source>
        <translation>Druck hält das Volumen</translation>
    </message>
    <message>
        <source>no pressure</source>
        <translation>kein Druck</translation>
    </message>
    <message>
        <source>Bulk modulus of what fills a closed surface: the larger, the less its volume gives way</source>
        <translation>Kompressionsmodul dessen, was eine geschlossene Oberfläche füllt: je größer, desto weniger gibt ihr Volumen nach</translation>
    </message>
    <message>
        <source>inch</source>
        <translation>Zoll</translation>
    </message>
    <message>
        <source>As the file itself states</source>
        <translation>Wie die Datei selbst angibt</translation>
    </message>
</context>
<context>
    <name>esm::RecoveryDialog</name>
    <message numerus="yes">
        <source>%n step(s), never saved</source>
        <translation>
            <numerusform>%n Schritt, nie gespeichert</numerusform>
            <numerusform>%n Schritte, nie gespeichert</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n step(s) after the last save</source>
        <translation>
            <numerusform>%n Schritt nach dem letzten Speichern</numerusform>
            <numerusform>%n Schritte nach dem letzten Speichern</numerusform>
        </translation>
    </message>
    <message>
        <source>a rule that was being written</source>
        <translation>eine Regel in Arbeit</translation>
    </message>
    <message>
        <source>no picture yet</source>
        <translation>noch kein Bild</translation>
    </message>
    <message>
        <source>Recover unsaved work</source>
        <translation>Nicht gespeicherte Arbeit wiederherstellen</translation>
    </message>
    <message>
        <source>The program ended before this was saved:</source>
        <translation>Das Programm endete, bevor dies gespeichert war:</translation>
    </message>
    <message>
        <source>&amp;Recover</source>
        <translation>&amp;Wiederherstellen</translation>
    </message>
    <message>
        <source>&amp;Discard</source>
        <translation>&amp;Verwerfen</translation>
    </message>
    <message>
        <source>&amp;Later</source>
        <translation>&amp;Später</translation>
    </message>
    <message>
        <source>Discard “%1”? It cannot be brought back.</source>
        <translation>„%1“ verwerfen? Es lässt sich nicht zurückholen.</translation>
    </message>
    <message>
        <source>Keeps everything; File &gt; Recover unsaved work shows it again</source>
        <translation>Behält alles; Datei &gt; Nicht gespeicherte Arbeit wiederherstellen zeigt es wieder</translation>
    </message>
    <message>
        <source>Untitled</source>
        <translation>Ohne Titel</translation>
    </message>
</context>
<context>
    <name>esm::RegionFields</name>
    <message>
        <source>change profile</source>
        <translation>Profil ändern</translation>
    </message>
    <message>
        <source>turn region inside out</source>
        <translation>Region umstülpen</translation>
    </message>
    <message>
        <source>rename region</source>
        <translation>Region umbenennen</translation>
    </message>
    <message>
        <source>move region</source>
        <translation>Region verschieben</translation>
    </message>
    <message>
        <source>resize region</source>
        <translation>Regionsgröße ändern</translation>
    </message>
    <message>
        <source>turn region</source>
        <translation>Region drehen</translation>
    </message>
    <message>
        <source>change falloff</source>
        <translation>Übergang ändern</translation>
    </message>
    <message>
        <source>move mirror plane</source>
        <translation>Spiegelebene verschieben</translation>
    </message>
    <message>
        <source>mirror region</source>
        <translation>Region spiegeln</translation>
    </message>
    <message>
        <source>own plane</source>
        <translation>eigene Ebene</translation>
    </message>
    <message numerus="yes">
        <source>%n spring(s)</source>
        <translation>
            <numerusform>%n Feder</numerusform>
            <numerusform>%n Federn</numerusform>
        </translation>
    </message>
    <message>
        <source>Name of the region</source>
        <translation>Name der Region</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>Centre [mm]</source>
        <translation>Mitte [mm]</translation>
    </message>
    <message>
        <source>Semi-axes [mm]</source>
        <translation>Halbachsen [mm]</translation>
    </message>
    <message>
        <source>Rotation [°]</source>
        <translation>Drehung [°]</translation>
    </message>
    <message>
        <source>Falloff</source>
        <translation>Übergang</translation>
    </message>
    <message>
        <source>Weight</source>
        <translation>Gewicht</translation>
    </message>
    <message>
        <source>Mirror</source>
        <translation>Spiegel</translation>
    </message>
    <message>
        <source>Centre %1 in mm</source>
        <translation>Mitte %1 in mm</translation>
    </message>
    <message>
        <source>Semi-axis %1 in mm</source>
        <translation>Halbachse %1 in mm</translation>
    </message>
    <message>
        <source>Rotation about %1 in degrees</source>
        <translation>Drehung um %1 in Grad</translation>
    </message>
    <message>
        <source>plane %1 at</source>
        <translation>Ebene %1 bei</translation>
    </message>
    <message>
        <source>Share of the radius over which the region fades out</source>
        <translation>Anteil des Radius, über den die Region ausklingt</translation>
    </message>
    <message>
        <source>How the weight falls from 1 to 0</source>
        <translation>Wie das Gewicht von 1 auf 0 fällt</translation>
    </message>
    <message>
        <source>smooth</source>
        <translation>sanft</translation>
    </message>
    <message>
        <source>linear</source>
        <translation>linear</translation>
    </message>
    <message>
        <source>smoother</source>
        <translation>sanfter</translation>
    </message>
    <message>
        <source>Weight from the centre outward; the line is the surface</source>
        <translation>Gewicht von der Mitte nach außen; der Strich ist die Oberfläche</translation>
    </message>
    <message>
        <source>Inside out</source>
        <translation>Umgestülpt</translation>
    </message>
    <message>
        <source>The region is what lies outside of the ellipsoid</source>
        <translation>Die Region ist, was außerhalb des Ellipsoids liegt</translation>
    </message>
    <message>
        <source>A twin behind a plane: both are one region</source>
        <translation>Ein Zwilling hinter einer Ebene: beide sind eine Region</translation>
    </message>
    <message>
        <source>none</source>
        <translation>keiner</translation>
    </message>
    <message>
        <source>Place of the mirror plane in mm</source>
        <translation>Lage der Spiegelebene in mm</translation>
    </message>
    <message>
        <source>Make twin a region of its own</source>
        <translation>Zwilling zu eigener Region machen</translation>
    </message>
    <message>
        <source>Springs that the region affects</source>
        <translation>Federn, auf die die Region wirkt</translation>
    </message>
</context>
<context>
    <name>esm::RegionsPanel</name>
    <message>
        <source>switch region on</source>
        <translation>Region einschalten</translation>
    </message>
    <message>
        <source>switch region off</source>
        <translation>Region ausschalten</translation>
    </message>
    <message>
        <source>%1 copy</source>
        <translation>%1 Kopie</translation>
    </message>
    <message>
        <source>Region %1</source>
        <translation>Region %1</translation>
    </message>
    <message>
        <source>Base tissue</source>
        <translation>Grundgewebe</translation>
    </message>
    <message>
        <source>Regions, later ones cover earlier ones</source>
        <translation>Regionen, spätere überdecken frühere</translation>
    </message>
    <message>
        <source>Add region</source>
        <translation>Region hinzufügen</translation>
    </message>
    <message>
        <source>Duplicate region</source>
        <translation>Region verdoppeln</translation>
    </message>
    <message>
        <source>Remove region</source>
        <translation>Region entfernen</translation>
    </message>
    <message>
        <source>Move region up</source>
        <translation>Region nach oben</translation>
    </message>
    <message>
        <source>Move region down</source>
        <translation>Region nach unten</translation>
    </message>
    <message>
        <source>Add a region around the selected nodes</source>
        <translation>Eine Region um die gewählten Knoten legen</translation>
    </message>
    <message>
        <source>Show the region in the preview</source>
        <translation>Die Region in der Vorschau zeigen</translation>
    </message>
    <message>
        <source>Lock the region against changes</source>
        <translation>Die Region gegen Änderungen sperren</translation>
    </message>
</context>
<context>
    <name>esm::RuleMatrixDelegate</name>
    <message>
        <source>no rule</source>
        <translation>keine Regel</translation>
    </message>
</context>
<context>
    <name>esm::RuleMatrixModel</name>
    <message>
        <source>%1, off</source>
        <translation>%1, aus</translation>
    </message>
    <message>
        <source>%1: no rule for %2.</source>
        <translation>%1: keine Regel für %2.</translation>
    </message>
    <message>
        <source>%1: %2 %3. Fires %4.</source>
        <translation>%1: %2 %3. Feuert %4.</translation>
    </message>
    <message>
        <source>Rule %1: %2</source>
        <translation>Regel %1: %2</translation>
    </message>
    <message>
        <source>No rule speaks here. Return or a double click makes one.</source>
        <translation>Hier spricht keine Regel. Eingabetaste oder Doppelklick legt eine an.</translation>
    </message>
    <message>
        <source>Clear a cell of the rule matrix</source>
        <translation>Zelle der Regelmatrix leeren</translation>
    </message>
    <message>
        <source>Set a cell of the rule matrix</source>
        <translation>Zelle der Regelmatrix setzen</translation>
    </message>
</context>
<context>
    <name>esm::RuleMatrixPage</name>
    <message>
        <source>Rows:</source>
        <translation>Zeilen:</translation>
    </message>
    <message>
        <source>Columns:</source>
        <translation>Spalten:</translation>
    </message>
    <message>
        <source>Result:</source>
        <translation>Ergebnis:</translation>
    </message>
    <message>
        <source>Input that spans the rows</source>
        <translation>Eingabe, die die Zeilen aufspannt</translation>
    </message>
    <message>
        <source>Input that spans the columns</source>
        <translation>Eingabe, die die Spalten aufspannt</translation>
    </message>
    <message>
        <source>Result that the cells show</source>
        <translation>Ergebnis, das die Zellen zeigen</translation>
    </message>
    <message>
        <source>Rules as matrix</source>
        <translation>Regeln als Matrix</translation>
    </message>
    <message>
        <source>Delete the rules of the selected cells</source>
        <translation>Regeln der gewählten Zellen löschen</translation>
    </message>
    <message>
        <source>A matrix needs two inputs and a result.</source>
        <translation>Eine Matrix braucht zwei Eingaben und ein Ergebnis.</translation>
    </message>
    <message numerus="yes">
        <source>%n rule(s) for this result also ask about other inputs and are not shown here.</source>
        <translation>
            <numerusform>%n Regel für dieses Ergebnis fragt auch nach anderen Eingaben und ist hier nicht gezeigt.</numerusform>
            <numerusform>%n Regeln für dieses Ergebnis fragen auch nach anderen Eingaben und sind hier nicht gezeigt.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>esm::RuleTableModel</name>
    <message>
        <source>off</source>
        <translation>aus</translation>
    </message>
    <message>
        <source>Rule %1 is on.</source>
        <translation>Regel %1 ist an.</translation>
    </message>
    <message>
        <source>Rule %1 is off.</source>
        <translation>Regel %1 ist aus.</translation>
    </message>
    <message>
        <source>On</source>
        <translation>An</translation>
    </message>
    <message>
        <source>Weight</source>
        <translation>Gewicht</translation>
    </message>
    <message>
        <source>Fires</source>
        <translation>Feuert</translation>
    </message>
    <message>
        <source>Note</source>
        <translation>Notiz</translation>
    </message>
    <message>
        <source>How strongly the rule fires for the current inputs, from 0 to 1.</source>
        <translation>Wie stark die Regel bei den jetzigen Eingaben feuert, von 0 bis 1.</translation>
    </message>
    <message>
        <source>How much the rule counts, from 0 to 1.</source>
        <translation>Wie viel die Regel zählt, von 0 bis 1.</translation>
    </message>
    <message>
        <source>Change the weight of rule %1</source>
        <translation>Gewicht von Regel %1 ändern</translation>
    </message>
    <message>
        <source>Change the note of rule %1</source>
        <translation>Notiz von Regel %1 ändern</translation>
    </message>
    <message>
        <source>Change rule %1</source>
        <translation>Regel %1 ändern</translation>
    </message>
    <message>
        <source>Add a rule</source>
        <translation>Regel hinzufügen</translation>
    </message>
    <message>
        <source>Duplicate a rule</source>
        <translation>Regel verdoppeln</translation>
    </message>
    <message>
        <source>Duplicate %1 rules</source>
        <translation>%1 Regeln verdoppeln</translation>
    </message>
    <message>
        <source>Delete a rule</source>
        <translation>Regel löschen</translation>
    </message>
    <message>
        <source>Delete %1 rules</source>
        <translation>%1 Regeln löschen</translation>
    </message>
    <message>
        <source>Move a rule</source>
        <translation>Regel verschieben</translation>
    </message>
    <message>
        <source>Move %1 rules</source>
        <translation>%1 Regeln verschieben</translation>
    </message>
    <message>
        <source>Switch a rule on</source>
        <translation>Regel einschalten</translation>
    </message>
    <message>
        <source>Switch %1 rules on</source>
        <translation>%1 Regeln einschalten</translation>
    </message>
    <message>
        <source>Switch a rule off</source>
        <translation>Regel ausschalten</translation>
    </message>
    <message>
        <source>Switch %1 rules off</source>
        <translation>%1 Regeln ausschalten</translation>
    </message>
</context>
<context>
    <name>esm::RuleTextPage</name>
    <message>
        <source>Line %1: %2 The rules stay as they were until this is mended.</source>
        <translation>Zeile %1: %2 Bis das behoben ist, gelten die Regeln wie zuvor.</translation>
    </message>
    <message>
        <source>The rules cannot be used: %1.</source>
        <translation>Die Regeln sind nicht verwendbar: %1.</translation>
    </message>
    <message>
        <source>Edit the rules as text</source>
        <translation>Regeln als Text bearbeiten</translation>
    </message>
    <message>
        <source>Rules as text, one per line</source>
        <translation>Regeln als Text, eine je Zeile</translation>
    </message>
    <message>
        <source>Write one rule per line. Ctrl+Space proposes words.</source>
        <translation>Eine Regel je Zeile schreiben. Strg+Leertaste schlägt Wörter vor.</translation>
    </message>
</context>
<context>
    <name>esm::RulesPanel</name>
    <message>
        <source>Rule %1: %2 The rule stays as it was until this is mended.</source>
        <translation>Regel %1: %2 Bis das behoben ist, gilt die Regel wie zuvor.</translation>
    </message>
    <message>
        <source>No rule fired for %1 (%2); it takes its default %3.</source>
        <translation>Keine Regel feuerte für %1 (%2); es gilt die Voreinstellung %3.</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>Hinzufügen</translation>
    </message>
    <message>
        <source>Add a rule that says what holds now</source>
        <translation>Eine Regel hinzufügen, die beschreibt, was jetzt gilt</translation>
    </message>
    <message>
        <source>Duplicate</source>
        <translation>Verdoppeln</translation>
    </message>
    <message>
        <source>Duplicate the selected rules</source>
        <translation>Die ausgewählten Regeln verdoppeln</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Löschen</translation>
    </message>
    <message>
        <source>Delete the selected rules</source>
        <translation>Die ausgewählten Regeln löschen</translation>
    </message>
    <message>
        <source>Up</source>
        <translation>Nach oben</translation>
    </message>
    <message>
        <source>Move the selected rules up</source>
        <translation>Die ausgewählten Regeln nach oben verschieben</translation>
    </message>
    <message>
        <source>Down</source>
        <translation>Nach unten</translation>
    </message>
    <message>
        <source>Move the selected rules down</source>
        <translation>Die ausgewählten Regeln nach unten verschieben</translation>
    </message>
    <message>
        <source>On/off</source>
        <translation>An/aus</translation>
    </message>
    <message>
        <source>Switch the selected rules on or off</source>
        <translation>Die ausgewählten Regeln ein- oder ausschalten</translation>
    </message>
    <message>
        <source>Table</source>
        <translation>Tabelle</translation>
    </message>
    <message>
        <source>Text (with mistakes)</source>
        <translation>Text (mit Fehlern)</translation>
    </message>
    <message>
        <source>Text</source>
        <translation>Text</translation>
    </message>
    <message>
        <source>Ways to show the rules</source>
        <translation>Ansichten der Regeln</translation>
    </message>
    <message>
        <source>Rules as table</source>
        <translation>Regeln als Tabelle</translation>
    </message>
    <message>
        <source>Gaps in the rules</source>
        <translation>Lücken in den Regeln</translation>
    </message>
    <message>
        <source>Matrix</source>
        <translation>Matrix</translation>
    </message>
</context>
<context>
    <name>esm::Sample</name>
    <message>
        <source>Fallopian tube</source>
        <translation>Eileiter</translation>
    </message>
    <message>
        <source>Gallbladder</source>
        <translation>Gallenblase</translation>
    </message>
    <message>
        <source>Uterus</source>
        <translation>Gebärmutter</translation>
    </message>
</context>
<context>
    <name>esm::SceneView</name>
    <message>
        <source>3D preview</source>
        <translation>3D-Vorschau</translation>
    </message>
    <message>
        <source>Keys: F fits, 1, 3 and 7 look from the front, the right and the top, arrows turn, + and - zoom.</source>
        <translation>Tasten: F zeigt alles, 1, 3 und 7 blicken von vorn, rechts und oben, Pfeile drehen, + und - zoomen.</translation>
    </message>
    <message>
        <source>3D preview needs OpenGL 3.3; everything else works.</source>
        <translation>Die 3D-Vorschau braucht OpenGL 3.3; alles andere funktioniert.</translation>
    </message>
    <message>
        <source>Here %1.</source>
        <translation>Hier: %1.</translation>
    </message>
</context>
<context>
    <name>esm::Solver</name>
    <message>
        <source>explicit, one force pass per step, second order</source>
        <translation>explizit, eine Kraftberechnung je Schritt, zweite Ordnung</translation>
    </message>
    <message>
        <source>explicit, with more viscous stages per step</source>
        <translation>explizit, mit mehr zähen Stufen je Schritt</translation>
    </message>
    <message>
        <source>the same by Stoermer&apos;s rule: waves keep in phase</source>
        <translation>ebenso, nach Störmers Regel: Wellen bleiben im Takt</translation>
    </message>
    <message>
        <source>explicit, second order in viscosity too</source>
        <translation>explizit, auch in der Zähigkeit zweite Ordnung</translation>
    </message>
    <message>
        <source>explicit multistep, one force pass per step, fourth order</source>
        <translation>explizites Mehrschrittverfahren, ein Kraftdurchgang je Schritt, vierte Ordnung</translation>
    </message>
    <message>
        <source>explicit, fourth order</source>
        <translation>explizit, vierte Ordnung</translation>
    </message>
    <message>
        <source>explicit, fifth order, for small errors</source>
        <translation>explizit, fünfte Ordnung, für kleine Fehler</translation>
    </message>
    <message>
        <source>implicit, second order, stable at any step: stiff nets</source>
        <translation>implizit, zweite Ordnung, stabil bei jedem Schritt: steife Netze</translation>
    </message>
    <message>
        <source>linearised implicit, first order, bounded</source>
        <translation>linearisiert implizit, erste Ordnung, beschränkt</translation>
    </message>
    <message>
        <source>implicit, first order, never gains energy</source>
        <translation>implizit, erste Ordnung, gewinnt nie Energie</translation>
    </message>
    <message>
        <source>each spring at its own rate: few stiff springs</source>
        <translation>jede Feder in ihrem Takt: wenige steife Federn</translation>
    </message>
    <message>
        <source>from the greatest force outward, as in 1999</source>
        <translation>von der größten Kraft nach außen, wie 1999</translation>
    </message>
    <message>
        <source>to the rest of each moment, without inertia</source>
        <translation>in die Ruhelage jedes Augenblicks, ohne Trägheit</translation>
    </message>
    <message>
        <source>the same without a factor, a frame at a time: keeps time under the hand</source>
        <translation>dasselbe ohne Faktorisierung, ein Bild auf einmal: hält unter der Hand mit der Zeit Schritt</translation>
    </message>
</context>
<context>
    <name>esm::StabilityLight</name>
    <message>
        <source>no model</source>
        <translation>kein Modell</translation>
    </message>
    <message>
        <source>stable</source>
        <translation>stabil</translation>
    </message>
    <message>
        <source>paused</source>
        <translation>angehalten</translation>
    </message>
    <message>
        <source>The model is too large or too stiff for this computer in real time: use fewer nodes, softer tissue or a looser tolerance.</source>
        <translation>Das Modell ist für diesen Rechner in Echtzeit zu groß oder zu steif: weniger Knoten, weicheres Gewebe oder eine größere Toleranz helfen.</translation>
    </message>
    <message>
        <source>stopped, last good state</source>
        <translation>gestoppt, letzter guter Stand</translation>
    </message>
    <message>
        <source>Stability: %1</source>
        <translation>Stabilität: %1</translation>
    </message>
    <message>
        <source>The tolerance is kept, by implicit steps. Softer tissue or heavier nodes would allow cheaper explicit ones.</source>
        <translation>Die Toleranz wird gehalten, mit impliziten Schritten. Weicheres Gewebe oder schwerere Knoten würden billigere explizite erlauben.</translation>
    </message>
    <message>
        <source>To keep real time, the error may be %1 % instead of %2 %.</source>
        <translation>Um Echtzeit zu halten, darf der Fehler %1 % statt %2 % sein.</translation>
    </message>
    <message>
        <source>stiff, implicit steps</source>
        <translation>steif, implizite Schritte</translation>
    </message>
    <message>
        <source>rougher than wanted</source>
        <translation>gröber als gewünscht</translation>
    </message>
    <message>
        <source>too heavy, no picture for %1 s</source>
        <translation>zu schwer, seit %1 s kein Bild</translation>
    </message>
    <message>
        <source>slowed, %1 × real time</source>
        <translation>verlangsamt, %1 × Echtzeit</translation>
    </message>
    <message>
        <source>Error of the motion, as its own steps tell: about %1 %</source>
        <translation>Fehler der Bewegung nach Auskunft ihrer eigenen Schritte: etwa %1 %</translation>
    </message>
    <message>
        <source>stopped</source>
        <translation>gestoppt</translation>
    </message>
    <message>
        <source>stiff</source>
        <translation>steif</translation>
    </message>
    <message>
        <source>rougher</source>
        <translation>gröber</translation>
    </message>
    <message>
        <source>no picture for %1 s</source>
        <translation>seit %1 s kein Bild</translation>
    </message>
    <message>
        <source>slowed</source>
        <translation>verlangsamt</translation>
    </message>
</context>
<context>
    <name>esm::StatusStrip</name>
    <message numerus="yes">
        <source>%n node(s)</source>
        <translation>
            <numerusform>%n Knoten</numerusform>
            <numerusform>%n Knoten</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n spring(s)</source>
        <translation>
            <numerusform>%n Feder</numerusform>
            <numerusform>%n Federn</numerusform>
        </translation>
    </message>
    <message>
        <source>%1, %2 behind</source>
        <translation>%1, %2 im Rückstand</translation>
    </message>
    <message>
        <source>real time %1×</source>
        <translation>Echtzeit %1×</translation>
    </message>
    <message>
        <source>t = %1 s</source>
        <translation>t = %1 s</translation>
    </message>
    <message>
        <source>Simulated time over wall time; a frame costs %1 % of its period</source>
        <translation>Simulierte Zeit zu Wanduhrzeit; ein Bild kostet %1 % seiner Dauer</translation>
    </message>
    <message>
        <source>solver %1</source>
        <translation>Löser %1</translation>
    </message>
    <message>
        <source>no device</source>
        <translation>kein Gerät</translation>
    </message>
    <message>
        <source>device %1 Hz</source>
        <translation>Gerät %1 Hz</translation>
    </message>
    <message>
        <source>%1: %2; %3 of %4 ticks late, worst %5 ms</source>
        <translation>%1: %2; %3 von %4 Takten verspätet, höchstens %5 ms</translation>
    </message>
    <message>
        <source>Accuracy as wanted: error up to %1 %</source>
        <translation>Genauigkeit wie gewünscht: Fehler bis %1 %</translation>
    </message>
    <message>
        <source>Larger error to keep real time: up to %1 % (step %2 of %3)</source>
        <translation>Größerer Fehler, um Echtzeit zu halten: bis %1 % (Stufe %2 von %3)</translation>
    </message>
    <message>
        <source>Rougher solver steps to keep real time; wanted error %1 % (step %2 of %3)</source>
        <translation>Gröbere Löserschritte, um Echtzeit zu halten; gewünschter Fehler %1 % (Stufe %2 von %3)</translation>
    </message>
    <message>
        <source>Nothing more may give way but the clock; wanted error %1 % (step %2 of %3)</source>
        <translation>Nur die Uhr darf noch nachgeben; gewünschter Fehler %1 % (Stufe %2 von %3)</translation>
    </message>
    <message>
        <source>%1 of %2 awake</source>
        <translation>%1 von %2 wach</translation>
    </message>
    <message>
        <source>real time %1×, tolerance %2 %</source>
        <translation>Echtzeit %1×, Toleranz %2 %</translation>
    </message>
    <message>
        <source>%1 of %2 nodes awake; the others rest and cost nothing</source>
        <translation>%1 von %2 Knoten wach; die anderen ruhen und kosten nichts</translation>
    </message>
    <message>
        <source>Last frame: %1 springs evaluated in %2 steps, %3 factorizations, %4 rejected steps</source>
        <translation>Letztes Bild: %1 Federn berechnet in %2 Schritten, %3 Faktorisierungen, %4 verworfene Schritte</translation>
    </message>
    <message>
        <source>Springs that the last edit of the tissue gave new numbers, and how long it took</source>
        <translation>Federn, denen die letzte Änderung am Gewebe neue Zahlen gab, und wie lange das dauerte</translation>
    </message>
    <message>
        <source>%1 of %2 springs derived, %3 ms</source>
        <translation>%1 von %2 Federn abgeleitet, %3 ms</translation>
    </message>
    <message>
        <source>Fewer nodes, softer tissue or heavier nodes help; what gives way is chosen in Simulation, Real time.</source>
        <translation>Weniger Knoten, weicheres Gewebe oder schwerere Knoten helfen; was nachgibt, ist unter Simulation, Echtzeit wählbar.</translation>
    </message>
    <message>
        <source>%1 awake</source>
        <translation>%1 wach</translation>
    </message>
</context>
<context>
    <name>esm::SurfacePanel</name>
    <message>
        <source>Result that the map shows</source>
        <translation>Ergebnis, das die Karte zeigt</translation>
    </message>
    <message>
        <source>Input along the lower axis</source>
        <translation>Eingabe entlang der unteren Achse</translation>
    </message>
    <message>
        <source>Input along the upright axis</source>
        <translation>Eingabe entlang der senkrechten Achse</translation>
    </message>
    <message>
        <source>over</source>
        <translation>über</translation>
    </message>
    <message>
        <source>and</source>
        <translation>und</translation>
    </message>
    <message>
        <source>Map</source>
        <translation>Karte</translation>
    </message>
    <message>
        <source>Table</source>
        <translation>Tabelle</translation>
    </message>
    <message>
        <source>Map or table</source>
        <translation>Karte oder Tabelle</translation>
    </message>
</context>
<context>
    <name>esm::SurfacePlot</name>
    <message>
        <source>Map of a result over two inputs</source>
        <translation>Karte eines Ergebnisses über zwei Eingaben</translation>
    </message>
    <message>
        <source>Change inputs on the surface</source>
        <translation>Eingaben auf der Fläche ändern</translation>
    </message>
    <message>
        <source>There is no result or there are no two inputs to show.</source>
        <translation>Es gibt kein Ergebnis oder keine zwei Eingaben zu zeigen.</translation>
    </message>
    <message>
        <source> (no rule)</source>
        <translation> (keine Regel)</translation>
    </message>
    <message>
        <source>%1 %2, %3 %4: %5 %6</source>
        <translation>%1 %2, %3 %4: %5 %6</translation>
    </message>
    <message>
        <source>No rule fires here.</source>
        <translation>Hier feuert keine Regel.</translation>
    </message>
</context>
<context>
    <name>esm::SurfaceTable</name>
    <message>
        <source>Results over both inputs</source>
        <translation>Ergebnisse über beiden Eingaben</translation>
    </message>
    <message>
        <source>Copy as CSV</source>
        <translation>Als CSV kopieren</translation>
    </message>
    <message>
        <source>Copy the table as CSV</source>
        <translation>Tabelle als CSV kopieren</translation>
    </message>
</context>
<context>
    <name>esm::TermEdits</name>
    <message>
        <source>Let memberships sum to 1</source>
        <translation>Zugehörigkeiten auf Summe 1 bringen</translation>
    </message>
    <message>
        <source>Change “%1”</source>
        <translation>„%1“ ändern</translation>
    </message>
    <message>
        <source>A word needs a name in both languages.</source>
        <translation>Ein Wort braucht einen Namen in beiden Sprachen.</translation>
    </message>
    <message>
        <source>“%1” is the name of another word of this variable.</source>
        <translation>„%1“ heißt schon ein anderes Wort dieser Größe.</translation>
    </message>
    <message>
        <source>Rename “%1”</source>
        <translation>„%1“ umbenennen</translation>
    </message>
    <message>
        <source>Change the form of “%1”</source>
        <translation>Form von „%1“ ändern</translation>
    </message>
    <message>
        <source>Add a word</source>
        <translation>Wort hinzufügen</translation>
    </message>
    <message>
        <source>“%1” stays: rules speak of it (%2). Change or delete them first.</source>
        <translation>„%1“ bleibt: Regeln sprechen davon (%2). Erst diese ändern oder löschen.</translation>
    </message>
    <message>
        <source>Remove “%1”</source>
        <translation>„%1“ entfernen</translation>
    </message>
    <message>
        <source>Rules speak of %1 words of this variable, so that fewer cannot be spread. Change or delete rules first.</source>
        <translation>Regeln sprechen von %1 Wörtern dieser Größe, weniger lassen sich nicht verteilen. Erst Regeln ändern oder löschen.</translation>
    </message>
    <message>
        <source>Spread words evenly</source>
        <translation>Wörter gleichmäßig verteilen</translation>
    </message>
</context>
<context>
    <name>esm::TermFields</name>
    <message>
        <source>Word to edit</source>
        <translation>Wort, das bearbeitet wird</translation>
    </message>
    <message>
        <source>Form of the word's curve</source>
        <translation>Form der Kurve</translation>
    </message>
    <message>
        <source>Add a word</source>
        <translation>Wort hinzufügen</translation>
    </message>
    <message>
        <source>Add a word where there is most room</source>
        <translation>Wort hinzufügen, wo am meisten Platz ist</translation>
    </message>
    <message>
        <source>Remove the word</source>
        <translation>Wort entfernen</translation>
    </message>
    <message>
        <source>Remove the word, if no rule speaks of it</source>
        <translation>Wort entfernen, wenn keine Regel davon spricht</translation>
    </message>
    <message>
        <source>English</source>
        <translation>Englisch</translation>
    </message>
    <message>
        <source>German</source>
        <translation>Deutsch</translation>
    </message>
    <message>
        <source>English name of the word</source>
        <translation>Englischer Name des Wortes</translation>
    </message>
    <message>
        <source>German name of the word</source>
        <translation>Deutscher Name des Wortes</translation>
    </message>
    <message>
        <source>triangle</source>
        <translation>Dreieck</translation>
    </message>
    <message>
        <source>trapezoid</source>
        <translation>Trapez</translation>
    </message>
    <message>
        <source>shoulder to the left</source>
        <translation>Schulter nach links</translation>
    </message>
    <message>
        <source>shoulder to the right</source>
        <translation>Schulter nach rechts</translation>
    </message>
    <message>
        <source>bell (Gauss)</source>
        <translation>Glocke (Gauß)</translation>
    </message>
    <message>
        <source>Place of the word</source>
        <translation>Lage des Wortes</translation>
    </message>
    <message>
        <source>deviation</source>
        <translation>Streuung</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source> decades</source>
        <translation> Dekaden</translation>
    </message>
</context>
<context>
    <name>esm::TermPlot</name>
    <message>
        <source>Tab goes from point to point, arrows move it, with Ctrl the whole curve, Delete removes the word.</source>
        <translation>Tab geht von Punkt zu Punkt, Pfeiltasten verschieben ihn, mit Strg die ganze Kurve, Entf entfernt das Wort.</translation>
    </message>
    <message>
        <source>left foot</source>
        <translation>linker Fuß</translation>
    </message>
    <message>
        <source>shoulder</source>
        <translation>Schulter</translation>
    </message>
    <message>
        <source>left shoulder</source>
        <translation>linke Schulter</translation>
    </message>
    <message>
        <source>peak</source>
        <translation>Spitze</translation>
    </message>
    <message>
        <source>right shoulder</source>
        <translation>rechte Schulter</translation>
    </message>
    <message>
        <source>right foot</source>
        <translation>rechter Fuß</translation>
    </message>
    <message>
        <source>left flank</source>
        <translation>linke Flanke</translation>
    </message>
    <message>
        <source>right flank</source>
        <translation>rechte Flanke</translation>
    </message>
    <message>
        <source>whole curve</source>
        <translation>ganze Kurve</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
</context>
<context>
    <name>esm::TissuePanel</name>
    <message>
        <source>Wall thickness</source>
        <translation>Wanddicke</translation>
    </message>
    <message>
        <source>Thickness of the organ's wall in mm</source>
        <translation>Dicke der Organwand in mm</translation>
    </message>
    <message>
        <source>Density</source>
        <translation>Dichte</translation>
    </message>
    <message>
        <source>The rules give this per place: change the words of the inputs</source>
        <translation>Die Regeln geben das je Ort vor: die Wörter der Eingaben ändern</translation>
    </message>
    <message>
        <source>Density of the tissue in kg/m³</source>
        <translation>Dichte des Gewebes in kg/m³</translation>
    </message>
    <message>
        <source>Force law</source>
        <translation>Kraftgesetz</translation>
    </message>
    <message>
        <source>How the springs answer their extension</source>
        <translation>Wie die Federn auf Dehnung antworten</translation>
    </message>
    <message>
        <source>Stiffening</source>
        <translation>Versteifung</translation>
    </message>
    <message>
        <source>Parameter of the force law: how fast the tissue stiffens</source>
        <translation>Parameter des Kraftgesetzes: wie schnell das Gewebe versteift</translation>
    </message>
    <message>
        <source>Gravity along z</source>
        <translation>Schwerkraft in z</translation>
    </message>
    <message>
        <source>Acceleration along z in m/s²; -9.81 is the Earth's</source>
        <translation>Beschleunigung in z in m/s²; -9,81 ist die der Erde</translation>
    </message>
    <message>
        <source>linear</source>
        <translation>linear</translation>
    </message>
    <message>
        <source>cubic</source>
        <translation>kubisch</translation>
    </message>
    <message>
        <source>exponential (tissue)</source>
        <translation>exponentiell (Gewebe)</translation>
    </message>
    <message>
        <source>Springs follow the tissue</source>
        <translation>Federn folgen dem Gewebe</translation>
    </message>
    <message>
        <source>Off: the springs keep the parameters that the net came with</source>
        <translation>Aus: Die Federn behalten die Parameter, mit denen das Netz kam</translation>
    </message>
</context>
<context>
    <name>esm::ToleranceNote</name>
    <message>
        <source>rough</source>
        <translation>grob</translation>
    </message>
    <message>
        <source>rough, error about %1 %</source>
        <translation>grob, Fehler etwa %1 %</translation>
    </message>
    <message>
        <source>tolerance given up until t = %1 s</source>
        <translation>Toleranz aufgegeben bis t = %1 s</translation>
    </message>
    <message>
        <source>To keep the tolerance of %1 % would have cost too much work: the motion is bounded, but rough.</source>
        <translation>Die Toleranz von %1 % zu halten hätte zu viel Arbeit gekostet: Die Bewegung ist beschränkt, aber grob.</translation>
    </message>
    <message>
        <source>What moves now comes from there. Reset begins anew.</source>
        <translation>Was sich jetzt bewegt, kommt von dort her. Zurücksetzen beginnt neu.</translation>
    </message>
    <message>
        <source>error about %1 %</source>
        <translation>Fehler etwa %1 %</translation>
    </message>
    <message>
        <source>rough until t = %1 s</source>
        <translation>grob bis t = %1 s</translation>
    </message>
</context>
<context>
    <name>esm::TracePlot</name>
    <message>
        <source>time [s]</source>
        <translation>Zeit [s]</translation>
    </message>
    <message>
        <source>tissue</source>
        <translation>Gewebe</translation>
    </message>
    <message>
        <source>device</source>
        <translation>Gerät</translation>
    </message>
    <message>
        <source>force [N]</source>
        <translation>Kraft [N]</translation>
    </message>
    <message>
        <source>Force over the last four seconds</source>
        <translation>Kraft der letzten vier Sekunden</translation>
    </message>
    <message>
        <source>position [mm]</source>
        <translation>Lage [mm]</translation>
    </message>
    <message>
        <source>Position of the hand over the last four seconds</source>
        <translation>Lage der Hand in den letzten vier Sekunden</translation>
    </message>
    <message>
        <source>work on the hand [mJ]</source>
        <translation>Arbeit an der Hand [mJ]</translation>
    </message>
    <message>
        <source>Work done on the hand since the device was connected</source>
        <translation>An der Hand verrichtete Arbeit, seit das Gerät verbunden ist</translation>
    </message>
</context>
<context>
    <name>esm::WhyPanel</name>
    <message>
        <source>The rules cannot be evaluated now, so nothing can be explained.</source>
        <translation>Die Regeln lassen sich gerade nicht auswerten, daher lässt sich nichts erklären.</translation>
    </message>
    <message>
        <source>Apply</source>
        <translation>Anwenden</translation>
    </message>
    <message>
        <source>Apply: %1</source>
        <translation>Anwenden: %1</translation>
    </message>
    <message>
        <source>The region is locked.</source>
        <translation>Die Region ist gesperrt.</translation>
    </message>
    <message>
        <source>Table (*.csv)</source>
        <translation>Tabelle (*.csv)</translation>
    </message>
    <message>
        <source>JSON (*.json)</source>
        <translation>JSON (*.json)</translation>
    </message>
    <message>
        <source>Save the explanation</source>
        <translation>Erklärung speichern</translation>
    </message>
    <message>
        <source>Explanation in one sentence</source>
        <translation>Erklärung in einem Satz</translation>
    </message>
    <message>
        <source>Copy and save the explanation</source>
        <translation>Erklärung kopieren und speichern</translation>
    </message>
    <message>
        <source>Copy sentence</source>
        <translation>Satz kopieren</translation>
    </message>
    <message>
        <source>Copy as CSV</source>
        <translation>Als CSV kopieren</translation>
    </message>
    <message>
        <source>Save as CSV…</source>
        <translation>Als CSV speichern …</translation>
    </message>
    <message>
        <source>Save as JSON…</source>
        <translation>Als JSON speichern …</translation>
    </message>
    <message>
        <source>Reason</source>
        <translation>Grund</translation>
    </message>
    <message>
        <source>Share</source>
        <translation>Anteil</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Wert</translation>
    </message>
    <message>
        <source>Reasons: geometry, regions, rules and inputs, the strongest first</source>
        <translation>Gründe: Geometrie, Regionen, Regeln und Eingaben, die stärksten zuerst</translation>
    </message>
    <message>
        <source>What would make it</source>
        <translation>Was macht es</translation>
    </message>
    <message>
        <source> %</source>
        <translation> %</translation>
    </message>
    <message>
        <source>By how many per cent</source>
        <translation>Um wie viel Prozent</translation>
    </message>
    <message>
        <source>softer?</source>
        <translation>weicher?</translation>
    </message>
    <message>
        <source>harder?</source>
        <translation>härter?</translation>
    </message>
    <message>
        <source>Softer or harder</source>
        <translation>Weicher oder härter</translation>
    </message>
    <message>
        <source>No input changes it.</source>
        <translation>Keine Eingabe ändert es.</translation>
    </message>
</context>
<context>
    <name>esm::WhyTree</name>
    <message>
        <source>stiffness of the tissue, E</source>
        <translation>Steifigkeit des Gewebes, E</translation>
    </message>
    <message>
        <source>By the tissue: %1</source>
        <translation>Nach dem Gewebe: %1</translation>
    </message>
    <message>
        <source>Tissue</source>
        <translation>Gewebe</translation>
    </message>
    <message>
        <source>Geometry and tissue here</source>
        <translation>Geometrie und Gewebe hier</translation>
    </message>
    <message>
        <source>No rule fires for it: this is the default.</source>
        <translation>Keine Regel feuert dafür: Das ist die Voreinstellung.</translation>
    </message>
    <message>
        <source>Rule %1: %2</source>
        <translation>Regel %1: %2</translation>
    </message>
    <message>
        <source>Without this rule: %1</source>
        <translation>Ohne diese Regel: %1</translation>
    </message>
</context>
<context>
    <name>esm::WindowActions</name>
    <message>
        <source>&amp;Pause</source>
        <translation>&amp;Pause</translation>
    </message>
    <message>
        <source>&amp;Play</source>
        <translation>&amp;Abspielen</translation>
    </message>
    <message>
        <source>&amp;New</source>
        <translation>&amp;Neu</translation>
    </message>
    <message>
        <source>New project without a model</source>
        <translation>Neues Projekt ohne Modell</translation>
    </message>
    <message>
        <source>&amp;Open…</source>
        <translation>Ö&amp;ffnen…</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>&amp;Speichern</translation>
    </message>
    <message>
        <source>Save &amp;as…</source>
        <translation>Speichern &amp;unter…</translation>
    </message>
    <message>
        <source>&amp;Import mesh…</source>
        <translation>Netz &amp;importieren…</translation>
    </message>
    <message>
        <source>Import a mesh: OBJ, STL, PLY and more</source>
        <translation>Ein Netz importieren: OBJ, STL, PLY und andere</translation>
    </message>
    <message>
        <source>Import</source>
        <translation>Importieren</translation>
    </message>
    <message>
        <source>&amp;Export shape…</source>
        <translation>Form &amp;exportieren…</translation>
    </message>
    <message>
        <source>Write the shape of this moment as mesh, VTU or CSV</source>
        <translation>Die augenblickliche Form als Netz, VTU oder CSV schreiben</translation>
    </message>
    <message>
        <source>&amp;Picture of the preview…</source>
        <translation>&amp;Bild der Vorschau…</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>&amp;Beenden</translation>
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
        <source>Re&amp;name project…</source>
        <translation>Projekt &amp;umbenennen…</translation>
    </message>
    <message>
        <source>&amp;Fit model</source>
        <translation>Alles &amp;zeigen</translation>
    </message>
    <message>
        <source>Show the whole model (F)</source>
        <translation>Das ganze Modell zeigen (F)</translation>
    </message>
    <message>
        <source>&amp;Surface</source>
        <translation>&amp;Oberfläche</translation>
    </message>
    <message>
        <source>S&amp;prings</source>
        <translation>&amp;Federn</translation>
    </message>
    <message>
        <source>&amp;Default layout</source>
        <translation>&amp;Standardanordnung</translation>
    </message>
    <message>
        <source>F&amp;ull screen</source>
        <translation>&amp;Vollbild</translation>
    </message>
    <message>
        <source>Plain</source>
        <translation>Einfarbig</translation>
    </message>
    <message>
        <source>Stiffness</source>
        <translation>Steifigkeit</translation>
    </message>
    <message>
        <source>Strain</source>
        <translation>Dehnung</translation>
    </message>
    <message>
        <source>Force</source>
        <translation>Kraft</translation>
    </message>
    <message>
        <source>Colour: %1</source>
        <translation>Farbe: %1</translation>
    </message>
    <message>
        <source>What the colours show</source>
        <translation>Was die Farben zeigen</translation>
    </message>
    <message>
        <source>As the system</source>
        <translation>Wie das System</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>Hell</translation>
    </message>
    <message>
        <source>Dark</source>
        <translation>Dunkel</translation>
    </message>
    <message>
        <source>&amp;Add region</source>
        <translation>Region &amp;hinzufügen</translation>
    </message>
    <message>
        <source>Add an ellipsoid of other tissue at the selected node</source>
        <translation>Ein Ellipsoid aus anderem Gewebe am gewählten Knoten hinzufügen</translation>
    </message>
    <message>
        <source>&amp;Hold selected node</source>
        <translation>Gewählten Knoten &amp;festhalten</translation>
    </message>
    <message>
        <source>Hold the selected node fast in space</source>
        <translation>Den gewählten Knoten im Raum festhalten</translation>
    </message>
    <message>
        <source>S&amp;tep</source>
        <translation>&amp;Schritt</translation>
    </message>
    <message>
        <source>One frame ahead</source>
        <translation>Ein Bild weiter</translation>
    </message>
    <message>
        <source>&amp;Reset</source>
        <translation>&amp;Zurücksetzen</translation>
    </message>
    <message>
        <source>Back to the shape at rest</source>
        <translation>Zurück zur Ruheform</translation>
    </message>
    <message>
        <source>&amp;Camera</source>
        <translation>&amp;Kamera</translation>
    </message>
    <message>
        <source>P&amp;ull</source>
        <translation>&amp;Ziehen</translation>
    </message>
    <message>
        <source>Pull: drag the tissue and feel its force</source>
        <translation>Ziehen: Gewebe ziehen und seine Kraft spüren</translation>
    </message>
    <message>
        <source>&amp;Select</source>
        <translation>Aus&amp;wahl</translation>
    </message>
    <message>
        <source>Automatic</source>
        <translation>Automatisch</translation>
    </message>
    <message>
        <source>&amp;Force on the device</source>
        <translation>&amp;Kraft am Gerät</translation>
    </message>
    <message>
        <source>Let the device feel the force; it fades in</source>
        <translation>Das Gerät die Kraft spüren lassen; sie blendet sich ein</translation>
    </message>
    <message>
        <source>&amp;Stop</source>
        <translation>S&amp;topp</translation>
    </message>
    <message>
        <source>&amp;Keys</source>
        <translation>&amp;Tasten</translation>
    </message>
    <message>
        <source>&amp;About this program</source>
        <translation>Ü&amp;ber dieses Programm</translation>
    </message>
    <message>
        <source>About &amp;Qt</source>
        <translation>Über &amp;Qt</translation>
    </message>
    <message>
        <source>&amp;File</source>
        <translation>&amp;Datei</translation>
    </message>
    <message>
        <source>Open &amp;recent</source>
        <translation>&amp;Zuletzt geöffnet</translation>
    </message>
    <message>
        <source>Sa&amp;mples</source>
        <translation>Beis&amp;piele</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>&amp;Bearbeiten</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>&amp;Ansicht</translation>
    </message>
    <message>
        <source>&amp;Colour by</source>
        <translation>&amp;Färbung</translation>
    </message>
    <message>
        <source>&amp;Panels</source>
        <translation>&amp;Fenster</translation>
    </message>
    <message>
        <source>&amp;Theme</source>
        <translation>&amp;Farbschema</translation>
    </message>
    <message>
        <source>&amp;Language</source>
        <translation>&amp;Sprache</translation>
    </message>
    <message>
        <source>&amp;Tissue</source>
        <translation>&amp;Gewebe</translation>
    </message>
    <message>
        <source>&amp;Simulation</source>
        <translation>&amp;Simulation</translation>
    </message>
    <message>
        <source>T&amp;ool</source>
        <translation>&amp;Werkzeug</translation>
    </message>
    <message>
        <source>So&amp;lver</source>
        <translation>&amp;Löser</translation>
    </message>
    <message>
        <source>&amp;Haptics</source>
        <translation>&amp;Haptik</translation>
    </message>
    <message>
        <source>Hel&amp;p</source>
        <translation>&amp;Hilfe</translation>
    </message>
    <message>
        <source>Tool bar</source>
        <translation>Werkzeugleiste</translation>
    </message>
    <message>
        <source>Camera: drag to turn, right button to move, wheel to zoom</source>
        <translation>Kamera: Ziehen dreht, rechte Taste verschiebt, Rad zoomt</translation>
    </message>
    <message>
        <source>Real &amp;time…</source>
        <translation>Ech&amp;tzeit…</translation>
    </message>
    <message>
        <source>What gives way when the model is too heavy for real time</source>
        <translation>Was nachgibt, wenn das Modell für Echtzeit zu schwer ist</translation>
    </message>
    <message>
        <source>The cheapest way that keeps the tolerance</source>
        <translation>Der billigste Weg, der die Toleranz hält</translation>
    </message>
    <message>
        <source>Weight of the region</source>
        <translation>Gewicht der Region</translation>
    </message>
    <message>
        <source>Select: click a node to see why it is as it is, or drag a box around several</source>
        <translation>Auswahl: Knoten anklicken, um zu sehen, warum er so ist, oder einen Kasten um mehrere ziehen</translation>
    </message>
    <message>
        <source>Re&amp;gion</source>
        <translation>Re&amp;gion</translation>
    </message>
    <message>
        <source>Region: move, turn and resize the chosen region by its handles</source>
        <translation>Region: die gewählte Region an ihren Griffen verschieben, drehen und in der Größe ändern</translation>
    </message>
    <message>
        <source>Force zero at once and let go; space does it too while force is on</source>
        <translation>Kraft sofort null und loslassen; die Leertaste tut es auch, solange die Kraft an ist</translation>
    </message>
    <message>
        <source>S&amp;truts</source>
        <translation>S&amp;treben</translation>
    </message>
    <message>
        <source>Struts and the springs of walls: what holds the organ up from inside</source>
        <translation>Streben und die Federn von Wänden: was das Organ von innen stützt</translation>
    </message>
    <message>
        <source>&amp;Recover unsaved work…</source>
        <translation>Nicht gespeicherte Arbeit &amp;wiederherstellen…</translation>
    </message>
    <message>
        <source>What earlier windows could not save</source>
        <translation>Was frühere Fenster nicht speichern konnten</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Stopp</translation>
    </message>
</context>
<context>
    <name>esm::ImportNote</name>
    <message>
        <source>Vertices joined with others at the same place: %1.</source>
        <translation>Mit anderen am selben Ort verbundene Eckpunkte: %1.</translation>
    </message>
    <message>
        <source>Vertices that nearly meet others: %1. A weld tolerance of %2 joins them.</source>
        <translation>Eckpunkte, die andere beinahe treffen: %1. Eine Toleranz von %2 verbindet sie.</translation>
    </message>
    <message>
        <source>Points that no face or line uses, and that become no nodes: %1.</source>
        <translation>Punkte, die keine Fläche oder Linie benutzt und die keine Knoten werden: %1.</translation>
    </message>
    <message>
        <source>Single points that were passed over: %1.</source>
        <translation>Übergangene einzelne Punkte: %1.</translation>
    </message>
    <message>
        <source>Unused vertices with coordinates that are not finite numbers: %1.</source>
        <translation>Unbenutzte Eckpunkte mit Koordinaten, die keine endlichen Zahlen sind: %1.</translation>
    </message>
    <message>
        <source>Faces with more than three corners, cut into triangles: %1.</source>
        <translation>Flächen mit mehr als drei Ecken, in Dreiecke zerlegt: %1.</translation>
    </message>
    <message>
        <source>Faces with fewer than three corners, read as lines: %1.</source>
        <translation>Flächen mit weniger als drei Ecken, als Linien gelesen: %1.</translation>
    </message>
    <message>
        <source>Cells of higher order, reduced to their corners: %1.</source>
        <translation>Zellen höherer Ordnung, auf ihre Ecken verkürzt: %1.</translation>
    </message>
    <message>
        <source>Hexahedra, wedges and pyramids that became their edges: %1.</source>
        <translation>Hexaeder, Keile und Pyramiden, von denen die Kanten blieben: %1.</translation>
    </message>
    <message>
        <source>Cells that are no tetrahedra and were passed over: %1.</source>
        <translation>Übergangene Zellen, die keine Tetraeder sind: %1.</translation>
    </message>
    <message>
        <source>The file is named .%1, but its content is %2; it was read as that.</source>
        <translation>Die Datei heißt .%1, ihr Inhalt ist aber %2; so wurde sie gelesen.</translation>
    </message>
    <message>
        <source>The header promises %1 facets, but %2 are there; all of these were read.</source>
        <translation>Der Anfang verspricht %1 Facetten, es sind aber %2 da; alle diese wurden gelesen.</translation>
    </message>
    <message>
        <source>The header promises %1 facets, but %2 are there; all of these were read. The file may be cut short.</source>
        <translation>Der Anfang verspricht %1 Facetten, es sind aber %2 da; alle diese wurden gelesen. Vielleicht ist die Datei abgeschnitten.</translation>
    </message>
    <message>
        <source>Bytes behind the end that were passed over: %1.</source>
        <translation>Übergangene Bytes hinter dem Ende: %1.</translation>
    </message>
    <message>
        <source>The word “%1” is written in two; it was read all the same.</source>
        <translation>Das Wort „%1“ ist getrennt geschrieben; es wurde trotzdem gelesen.</translation>
    </message>
    <message>
        <source>Lines between facets that were passed over: %1 (the first begins with “%2”).</source>
        <translation>Übergangene Zeilen zwischen den Facetten: %1 (die erste beginnt mit „%2“).</translation>
    </message>
    <message>
        <source>Header lines that were passed over: %1 (the first begins with “%2”).</source>
        <translation>Übergangene Zeilen des Anfangs: %1 (die erste beginnt mit „%2“).</translation>
    </message>
    <message>
        <source>The file ends without “%1”; it may be cut short.</source>
        <translation>Die Datei endet ohne „%1“; vielleicht ist sie abgeschnitten.</translation>
    </message>
    <message>
        <source>Read as strips of triangles from the element “%2”: %1.</source>
        <translation>Aus dem Element „%2“ als Streifen von Dreiecken gelesen: %1.</translation>
    </message>
    <message>
        <source>Read as fans of triangles from the element “%2”: %1.</source>
        <translation>Aus dem Element „%2“ als Fächer von Dreiecken gelesen: %1.</translation>
    </message>
    <message>
        <source>Read as lines from the element “%2”: %1.</source>
        <translation>Aus dem Element „%2“ als Linien gelesen: %1.</translation>
    </message>
    <message>
        <source>Read as tetrahedra from the element “%2”: %1.</source>
        <translation>Aus dem Element „%2“ als Tetraeder gelesen: %1.</translation>
    </message>
    <message>
        <source>Read as faces from the element “%2”: %1.</source>
        <translation>Aus dem Element „%2“ als Flächen gelesen: %1.</translation>
    </message>
    <message>
        <source>Passed over of the element “%2”: %1.</source>
        <translation>Übergangen vom Element „%2“: %1.</translation>
    </message>
    <message>
        <source>Statements for points, curves or free-form surfaces that were passed over: %1.</source>
        <translation>Übergangene Anweisungen für Punkte, Kurven oder Freiformflächen: %1.</translation>
    </message>
    <message>
        <source>Lines with unknown keywords that were passed over: %1, the first is line %2.</source>
        <translation>Übergangene Zeilen mit unbekannten Schlüsselwörtern: %1, die erste ist Zeile %2.</translation>
    </message>
    <message>
        <source>Arcs of polylines that became their chords: %1.</source>
        <translation>Bögen von Linienzügen, von denen die Sehnen blieben: %1.</translation>
    </message>
    <message>
        <source>Entities that are no lines or faces and were passed over: %1 (%2).</source>
        <translation>Übergangene Objekte, die weder Linien noch Flächen sind: %1 (%2).</translation>
    </message>
    <message>
        <source>Entities in paper space that were passed over: %1.</source>
        <translation>Übergangene Objekte im Papierbereich: %1.</translation>
    </message>
    <message>
        <source>Invisible entities that were passed over: %1.</source>
        <translation>Übergangene unsichtbare Objekte: %1.</translation>
    </message>
    <message>
        <source>Entities on layers that are frozen or off, passed over: %1 (%2).</source>
        <translation>Übergangene Objekte auf gefrorenen oder ausgeschalteten Layern: %1 (%2).</translation>
    </message>
    <message>
        <source>Lines that begin with a colour, which was passed over: %1.</source>
        <translation>Zeilen, die mit einer Farbe beginnen, die übergangen wurde: %1.</translation>
    </message>
    <message>
        <source>Lines with twelve numbers, read as quads: %1.</source>
        <translation>Zeilen mit zwölf Zahlen, als Vierecke gelesen: %1.</translation>
    </message>
    <message>
        <source>Its part “%1” is missing here: %2.</source>
        <translation>Ihr Teil „%1“ fehlt hier: %2.</translation>
    </message>
    <message>
        <source>Its part “%1” is missing here (and %2 more): %3.</source>
        <translation>Ihr Teil „%1“ fehlt hier (und %2 weitere): %3.</translation>
    </message>
    <message>
        <source>More of its parts that are missing: %1.</source>
        <translation>Weitere fehlende Teile: %1.</translation>
    </message>
    <message>
        <source>The kernel offers no seccomp, so the foreign reader of this format was not kept from the network.</source>
        <translation>Der Systemkern bietet kein seccomp; der fremde Leser dieses Formats war nicht vom Netzwerk getrennt.</translation>
    </message>
    <message>
        <source>Pulled along its longest axis the net was %1 times as stiff as the body; its springs are scaled by %2.</source>
        <translation>Entlang seiner längsten Achse gezogen war das Netz %1-mal so steif wie der Körper; seine Federn sind mit %2 skaliert.</translation>
    </message>
    <message>
        <source>Polygons&apos; edges are gone with the remeshing, all triangle edges are springs.</source>
        <translation>Die Kanten der Vielecke sind mit der Neuvernetzung verloren; alle Dreieckskanten sind Federn.</translation>
    </message>
    <message>
        <source>Nodes of the surface that found no wall opposite and got no strut: %1.</source>
        <translation>Knoten der Oberfläche, die keine Wand gegenüber fanden und keine Strebe bekamen: %1.</translation>
    </message>
    <message>
        <source>The wall is %1 mm thick, layers of cells: %2, volume: %3 cm³; its springs miss an even stiffness by %4 %.</source>
        <translation>Die Wand ist %1 mm dick, Lagen von Zellen: %2, Volumen: %3 cm³; ihre Federn verfehlen eine gleichmäßige Steifigkeit um %4 %.</translation>
    </message>
    <message>
        <source>Nodes where the wall had to be thinner: %1, down to %2 mm. The opposite wall is near there, or the surface bends sharply.</source>
        <translation>Knoten, an denen die Wand dünner sein muss: %1, bis hinab zu %2 mm. Dort ist die Gegenwand nahe, oder die Oberfläche biegt sich scharf.</translation>
    </message>
    <message>
        <source>Triangles of the inner surface that still run through others: %1. Repair the surface there.</source>
        <translation>Dreiecke der inneren Oberfläche, die noch durch andere laufen: %1. Dort die Oberfläche reparieren.</translation>
    </message>
    <message>
        <source>Removed: %1 triangles without area.</source>
        <translation>Entfernte Dreiecke ohne Fläche: %1.</translation>
    </message>
    <message>
        <source>Removed: %1 triangles that were there twice.</source>
        <translation>Entfernte doppelte Dreiecke: %1.</translation>
    </message>
    <message>
        <source>Removed: %1 lines without length or there twice.</source>
        <translation>Entfernte Linien ohne Länge oder doppelte: %1.</translation>
    </message>
    <message>
        <source>Removed: %1 vertices that nothing used.</source>
        <translation>Entfernte unbenutzte Eckpunkte: %1.</translation>
    </message>
    <message>
        <source>Vertices tied to the edges they only lay on: %1.</source>
        <translation>An die Kanten gebundene Eckpunkte, die nur auf ihnen lagen: %1.</translation>
    </message>
    <message>
        <source>Made %1 triangles of %2, with edges from %3 to %4 m.</source>
        <translation>%1 Dreiecke aus %2 gemacht, mit Kanten von %3 bis %4 m.</translation>
    </message>
    <message>
        <source>The many fine creases were taken for roughness and smoothed over; more triangles keep them.</source>
        <translation>Die vielen feinen Falten galten als Rauheit und wurden geglättet; mehr Dreiecke erhalten sie.</translation>
    </message>
    <message>
        <source>It could not come down to %1 triangles: lines, creases, seams or many small parts hold the others.</source>
        <translation>Bis auf %1 Dreiecke ging es nicht herunter: Linien, Falten, Nähte oder viele kleine Teile halten die übrigen.</translation>
    </message>
    <message>
        <source>Some edges stay more than 5 times shorter than others: lines, creases, seams or small parts hold them, and the shortest sets the time step.</source>
        <translation>Manche Kanten bleiben über 5-mal kürzer als andere: Linien, Falten, Nähte oder kleine Teile halten sie, und die kürzeste bestimmt den Zeitschritt.</translation>
    </message>
    <message>
        <source>Holes that were filled: %1, with %2 triangles.</source>
        <translation>Gefüllte Löcher: %1, mit %2 Dreiecken.</translation>
    </message>
    <message>
        <source>Borders that stay open: %1. They are larger than asked for, or not closed, or without area.</source>
        <translation>Ränder, die offen bleiben: %1. Sie sind größer als verlangt, nicht geschlossen oder ohne Fläche.</translation>
    </message>
    <message>
        <source>Left out: %1 vertices that lie nowhere (NaN or infinite), and %2 triangles on them.</source>
        <translation>Weggelassen: %1 Eckpunkte ohne Ort (NaN oder unendlich) und %2 Dreiecke daran.</translation>
    </message>
    <message>
        <source>Dropped: %1 of %2 parts, %3 elements in all.</source>
        <translation>Weggelassen: %1 von %2 Teilen, zusammen %3 Elemente.</translation>
    </message>
    <message>
        <source>Triangles turned round: %1.</source>
        <translation>Umgedrehte Dreiecke: %1.</translation>
    </message>
    <message>
        <source>Edges over which neighbours cannot agree on a side: %1. The surface is twisted like a Moebius strip.</source>
        <translation>Kanten, über die sich Nachbarn auf keine Seite einigen können: %1. Die Fläche ist verdreht wie ein Möbiusband.</translation>
    </message>
    <message>
        <source>The axes that the file states for a patient could not be read; choose them yourself.</source>
        <translation>Die Achsen eines Patienten, die die Datei angibt, waren nicht lesbar; bitte selbst wählen.</translation>
    </message>
    <message>
        <source>The unit that the file states, “%1”, is no length and is not used; choose it yourself.</source>
        <translation>Die Einheit, die die Datei angibt, „%1“, ist keine Länge und gilt nicht; bitte selbst wählen.</translation>
    </message>
    <message>
        <source>The file states %1, which is used.</source>
        <translation>Die Datei gibt an: %1. Das gilt.</translation>
    </message>
    <message>
        <source>The file states %1; as wished, the choices hold and not that.</source>
        <translation>Die Datei gibt an: %1. Wie gewünscht gelten statt dessen die Angaben hier.</translation>
    </message>
    <message>
        <source>%1 and %2</source>
        <translation>%1 und %2</translation>
    </message>
    <message>
        <source>metres</source>
        <translation>Meter</translation>
    </message>
    <message>
        <source>decimetres</source>
        <translation>Dezimeter</translation>
    </message>
    <message>
        <source>centimetres</source>
        <translation>Zentimeter</translation>
    </message>
    <message>
        <source>millimetres</source>
        <translation>Millimeter</translation>
    </message>
    <message>
        <source>micrometres</source>
        <translation>Mikrometer</translation>
    </message>
    <message>
        <source>kilometres</source>
        <translation>Kilometer</translation>
    </message>
    <message>
        <source>inches</source>
        <translation>Zoll</translation>
    </message>
    <message>
        <source>feet</source>
        <translation>Fuß</translation>
    </message>
    <message>
        <source>yards</source>
        <translation>Yards</translation>
    </message>
    <message>
        <source>units of %1 m</source>
        <translation>Einheiten von %1 m</translation>
    </message>
    <message>
        <source>x up</source>
        <translation>x oben</translation>
    </message>
    <message>
        <source>y up</source>
        <translation>y oben</translation>
    </message>
    <message>
        <source>z up</source>
        <translation>z oben</translation>
    </message>
    <message>
        <source>a patient&apos;s axes (%1)</source>
        <translation>Achsen des Patienten (%1)</translation>
    </message>
    <message>
        <source>The section promises %1 nodes, but %2 are there; all of these were read.</source>
        <translation>Der Abschnitt verspricht %1 Knoten, es sind aber %2 da; alle diese wurden gelesen.</translation>
    </message>
    <message>
        <source>The section promises %1 elements, but %2 are there; all of these were read.</source>
        <translation>Der Abschnitt verspricht %1 Elemente, es sind aber %2 da; alle diese wurden gelesen.</translation>
    </message>
    <message>
        <source>The attribute %1 promises %2 cells, but %3 are there; all of these were read.</source>
        <translation>Das Attribut %1 verspricht %2 Zellen, es sind aber %3 da; alle diese wurden gelesen.</translation>
    </message>
    <message>
        <source>Lines behind the %2 that were passed over: %1, the first is line %3. Is the count wrong?</source>
        <translation>Übergangene Zeilen hinter den %2: %1, die erste ist Zeile %3. Ist die Anzahl falsch?</translation>
    </message>
    <message>
        <source>The reading library went on after a fault, a part may be missing: %1.</source>
        <translation>Die lesende Bibliothek fuhr nach einem Fehler fort, vielleicht fehlt ein Teil: %1.</translation>
    </message>
</context>
</TS>
