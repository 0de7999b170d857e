package nephele.app.command;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** `nephele trade` runs from the command line with an offscreen OpenGL context. */
class TradeGlTest {
    /** Two doors that face each other in the simplest light, which leaves little to compile. */
    private static final String TWO_DOORS =
            """
            {
              "format": "nephele-level",
              "version": 1,
              "environment": {"ambient": [0.5, 0.5, 0.5]},
              "player": {"feet": [0, 0, 2]},
              "cameras": [{"id": "main", "position": [0.4, 1.6, 2], "target": [0, 1, -3]}],
              "materials": [
                {"id": "red", "baseColour": [0.8, 0.2, 0.1]},
                {"id": "blue", "baseColour": [0.1, 0.3, 0.8]}
              ],
              "solids": [
                {"id": "floor", "kind": "box", "material": "red", "centre": [0, -0.5, 0], "size": [9, 1, 9]},
                {"id": "wall", "kind": "box", "material": "blue", "centre": [0, 2, -3.5], "size": [9, 4, 1]}
              ],
              "portals": [
                {"id": "a", "linkedTo": "b", "centre": [0, 1.2, -3], "normal": [0, 0, 1], "widthMetres": 1.4, "heightMetres": 2.4},
                {"id": "b", "linkedTo": "a", "centre": [3, 1.2, 4], "normal": [0, 0, -1], "widthMetres": 1.4, "heightMetres": 2.4}
              ]
            }
            """;

    @TempDir
    Path folder;

    @Test
    void reportsPicturesOfALevel() throws IOException {
        Path level = Files.writeString(folder.resolve("two-doors.json"), TWO_DOORS);
        Path out = folder.resolve("report");
        var run = measured("portalTechnique", "32x18", level, out);
        assertEquals("", run.exitCode() == 0 ? "" : run.err());
        assertEquals(out.resolve("index.html") + "\n", run.out());
        String page = Files.readString(out.resolve("index.html"));
        assertTrue(page.contains("data:image/jpeg;base64,") && page.contains("copy_area"));
        var lines = Files.readAllLines(out.resolve("trade.csv"));
        assertEquals(5, lines.size());
        // All techniques draw the same picture: the same error to the last digit.
        assertEquals(
                1,
                lines.stream()
                        .skip(1)
                        .map(line -> line.split(",")[7])
                        .distinct()
                        .count());
        assertTrue(Files.size(out.resolve("pictures/portalTechnique-exact.png")) > 0);

        var resumed = measured("portalTechnique", "32x18", level, out);
        assertTrue(resumed.err().contains("was measured before"), resumed.err());
        assertTrue(
                graphics(page).length() > 3
                        && graphics(page).equals(graphics(Files.readString(out.resolve("index.html")))),
                "a resumed page says what drew it");
    }

    private static String graphics(String page) {
        return page.replaceFirst("(?s).*?(llvmpipe[^<]*|softpipe[^<]*|$).*", "$1");
    }

    /** Edges that are not smoothed shimmer and err most; the filter is in between, samples are best. */
    @Test
    void judgesEdgesByManySamples() throws IOException {
        Path level = Files.writeString(folder.resolve("two-doors.json"), TWO_DOORS);
        var run = measured("antialiasing", "64x36", level, folder);
        assertEquals("", run.exitCode() == 0 ? "" : run.err());
        var rows = Files.readAllLines(folder.resolve("trade.csv")).stream()
                .map(line -> line.split(","))
                .toList();
        assertEquals("shimmer", rows.get(1)[21]);
        assertEquals("RMSE at edges", rows.get(1)[23]);
        for (int figure : new int[] {22, 24}) {
            double none = Double.parseDouble(rows.get(1)[figure]);
            double filtered = Double.parseDouble(rows.get(2)[figure]);
            double sampled = Double.parseDouble(rows.get(3)[figure]);
            String what = figure + ": " + none + ", " + filtered + ", " + sampled;
            assertTrue(none > filtered && filtered > sampled && sampled > 0, what);
        }
    }

    private static Captured measured(String subject, String size, Path level, Path out) {
        return Captured.run(
                "trade",
                subject,
                "--quick",
                "--rounds",
                "1",
                "--size",
                size,
                "--spp",
                "1",
                "--level",
                level.toString(),
                "--out",
                out.toString());
    }

    @Test
    void explainsWhatItCannotDo() throws IOException {
        Path file = Files.writeString(folder.resolve("file"), "");
        Object[][] wrong = {
            {2, "there is no subject `nonsense`", "trade nonsense --out " + folder},
            {2, "--out DIR", "trade shadow"},
            {2, "--rounds is a whole number from 1", "trade --rounds 0 --out " + folder},
            {2, "--spp is a whole number from 1", "trade --spp 0 --out " + folder},
            {3, "can't be made: ", "trade shadow --out " + file.resolve("in")},
            {1, "none.json: $: ", "trade shadow --level none.json --out " + folder},
            {
                1,
                "there is no camera `no`",
                "trade shadow --camera no --level levels/samples/portals.json --out " + folder
            },
        };
        for (Object[] each : wrong) {
            var run = Captured.run(((String) each[2]).split(" "));
            assertEquals(each[0], run.exitCode(), each[2] + ": " + run.err());
            assertTrue(run.err().contains((String) each[1]), each[2] + ": " + run.err());
        }
    }

    @Test
    void listsSubjectsAndSettings() {
        var run = Captured.run("trade", "--list", "shadow");
        assertEquals(0, run.exitCode());
        assertTrue(run.out().startsWith("shadow: Sun shadow\n  off  no shadows at all\n  256\n"), run.out());
    }
}
