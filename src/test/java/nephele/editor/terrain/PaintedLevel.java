package nephele.editor.terrain;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.TreeMap;
import java.util.stream.Stream;
import nephele.editor.save.DocumentFile;
import nephele.editor.session.EditorSession;
import nephele.editor.session.EditorSettings;
import nephele.engine.asset.HeightMap;
import nephele.engine.level.Terrain;

/** A level with a flat terrain, 64 m square around the origin, in a folder of its own; heights from 0 to 10 m. */
public record PaintedLevel(Path file) {
    /** Writes the level and its map. */
    public static PaintedLevel in(Path folder) throws IOException {
        return in(folder, "");
    }

    /** Writes the level with two layers, grass below 5 m and rock above. */
    public static PaintedLevel layered(Path folder) throws IOException {
        return in(
                folder,
                """
                , "layers": [{"material": "grass", "toMetres": 5}, {"material": "rock", "fromMetres": 5}]
                """);
    }

    private static PaintedLevel in(Path folder, String layers) throws IOException {
        short[] values = new short[33 * 33];
        Arrays.fill(values, (short) 20_000);
        Files.write(folder.resolve("flat.png"), new HeightMap(33, 33, 16, values).png());
        return new PaintedLevel(Files.writeString(
                folder.resolve("level.json"),
                """
                {"format": "nephele-level", "version": 1, "player": {"feet": [0, 4, 0]},
                "materials": [{"id": "grass", "baseColour": [0.1, 0.4, 0.1]}, {"id": "rock"}], "terrains": [{"id": "hills",
                "heightMap": "flat.png", "centre": [0, 0, 0], "sizeMetres": [64, 64], "heightRangeMetres": [0, 10]%s}]}
                """
                        .formatted(layers)));
    }

    /** Opens it. */
    public EditorSession open() {
        DocumentFile.Opened opened = DocumentFile.open(file.toString());
        return new EditorSession(opened.file(), opened.level(), opened.assets(), EditorSettings.DEFAULT);
    }

    /** Returns the terrain of what a session shows. */
    public static Terrain terrain(EditorSession session) {
        return session.document().level().terrains().get(0);
    }

    /** Returns the heights of what a session shows. */
    public static HeightMap map(EditorSession session) {
        return session.assets().decoded(terrain(session).heightMap(), HeightMap.class, HeightMap::read);
    }

    /** Returns the contents of all files that strokes have made, by their names. */
    public TreeMap<String, List<Byte>> painted() throws IOException {
        TreeMap<String, List<Byte>> contents = new TreeMap<>();
        Path folder = file.resolveSibling("terrain");
        if (Files.isDirectory(folder)) {
            try (Stream<Path> files = Files.list(folder)) {
                for (Path each : files.toList()) {
                    byte[] bytes = Files.readAllBytes(each);
                    List<Byte> list = new ArrayList<>();
                    for (byte b : bytes) {
                        list.add(b);
                    }
                    contents.put("terrain/" + each.getFileName(), list);
                }
            }
        }
        return contents;
    }
}
