package nephele.app.command;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import nephele.scenes.file.OpenedScene;
import nephele.scenes.file.SceneName;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** A file with many equal oddities: the warnings that matter are not lost among them. */
class EqualWarningsTest {
    private static final int MANY = 2000;

    @TempDir
    Path folder;

    private String scene(String oddGroup, String rest) throws IOException {
        String groups = IntStream.range(0, MANY).mapToObj(i -> oddGroup + "\n").collect(Collectors.joining());
        return Files.writeString(folder.resolve("s.xml"), "<world>\n" + groups + rest + "</world>")
                .toString();
    }

    private List<String> warnings(String scene) {
        List<String> warnings = new ArrayList<>();
        OpenedScene.of(new SceneName(scene), null, null, warnings::add);
        return warnings;
    }

    @Test
    void ofASceneAreCountedInShowingAndImport() throws IOException {
        String odd = "<group shade='1'><models><model file='box_1_1.3d'/></models></group>";
        String other = "<group><scale y='1'/></group>\n";
        String scene = scene(odd, other + "<lights><light type='point'/></lights>");
        List<String> shown = warnings(scene);
        assertEquals(2, shown.size(), shown.toString());
        assertTrue(shown.get(0).startsWith(scene + ":2: 'shade'"), shown.get(0));
        assertTrue(shown.get(0).endsWith(" (" + MANY + " times)"), shown.get(0));
        assertTrue(shown.get(1).startsWith(scene + ":" + (MANY + 2) + ": <scale>"), shown.get(1));

        List<String> imported = Captured.run(
                        "import", scene, "--out", folder.resolve("a.json").toString())
                .err()
                .lines()
                .toList();
        assertTrue(imported.contains(shown.get(0)) && imported.contains(shown.get(1)), imported.toString());
        assertEquals(imported.size(), imported.stream().distinct().count());
    }

    @Test
    void ofALevelAreCountedWithTheirFirstPlaces() throws IOException {
        String solids = IntStream.range(0, 20)
                .mapToObj(i -> "{\"id\": \"s" + i + "\", \"kind\": \"box\", \"centre\": [0, " + 9 * i
                        + ", 0], \"size\": [1, 0.0005, 1]}")
                .collect(Collectors.joining(","));
        String level =
                "{\"format\": \"nephele-level\", \"version\": 1, \"player\": {\"feet\": [9, 0, 9]}, \"solids\": ["
                        + solids + "]}";
        Path file = Files.writeString(folder.resolve("l.json"), level);
        List<String> thin = Captured.run("check", file.toString())
                .out()
                .lines()
                .filter(line -> line.contains("mm thick"))
                .toList();
        assertEquals(1, thin.size(), thin.toString());
        assertTrue(thin.get(0).startsWith(file + ": solids[0]: warning: "), thin.get(0));
        assertTrue(thin.get(0).contains(" times), also at solids[1], "), thin.get(0));
    }

    @Test
    void aNameIsAllowedOnEveryElement() throws IOException {
        String odd = "<group name='asteroid'><models name='m'><model name='n' file='box_1_1.3d'/></models></group>";
        assertEquals(List.of(), warnings(scene(odd, "<lights name='l'><light name='sun' type='point'/></lights>")));
    }

    @Test
    void aSceneWithoutLightSaysWhyItIsDark() throws IOException {
        String model = "<group><models><model file='box_1_1.3d'>%s</model></models></group>";
        String glowing = String.format(model, "<color><emissive R='9' G='9' B='9'/></color>");
        List<String> dark = warnings(scene(String.format(model, ""), ""));
        assertEquals(1, dark.size(), dark.toString());
        assertTrue(dark.get(0).contains(":1: it is dark, because no light reaches its models; add <lights>"));
        assertFalse(warnings(scene(glowing, "")).toString().contains("dark"));
    }
}
