package nephele.app.command;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** `render --reference` in shards, merged, interrupted and with its standard error. */
class ShardedRenderTest {
    private static final String LEVEL = "{\"format\": \"nephele-level\", \"version\": 1, \"environment\": {"
            + "\"sun\": {\"directionTowardsSun\": [1, 2, 1], \"irradiance\": [3, 3, 3]}, "
            + "\"sky\": {\"kind\": \"constant\", \"radiance\": [0.2, 0.3, 0.5]}, "
            + "\"clouds\": [{\"id\": \"c\", \"kind\": \"volume\", \"centre\": [0, 0, -100], \"size\": [60, 40, 60], "
            + "\"extinctionPerMetre\": 0.05, \"phaseG\": 0.85}]}, "
            + "\"cameras\": [{\"id\": \"main\", \"position\": [0, 0, 0], \"target\": [0, 0, -1]}], "
            + "\"solids\": [{\"id\": \"s\", \"kind\": \"box\", \"centre\": [10, 0, -40], \"size\": [8, 8, 8]}]}";
    private static final String SIZE = "40x24";

    @TempDir
    Path folder;

    private String level;

    @BeforeEach
    void writeLevel() throws IOException {
        level = Files.writeString(folder.resolve("level.json"), LEVEL).toString();
    }

    private String out(String name) {
        return folder.resolve(name).toString();
    }

    private static Captured done(String... words) {
        Captured answer = Captured.run(words);
        assertEquals(0, answer.exitCode(), answer.err());
        return answer;
    }

    /** Traces with usual options where none are given. */
    private Captured traced(String out, String... options) {
        List<String> words = new ArrayList<>(List.of("render", level, "--reference", "--out", out(out)));
        words.addAll(List.of(options));
        String[][] usual = {{"--size", SIZE}, {"--spp", "40"}, {"--seed", "7"}};
        for (String[] option : usual) {
            if (!words.contains(option[0])) {
                words.addAll(List.of(option));
            }
        }
        return done(words.toArray(String[]::new));
    }

    private byte[] bytes(String name) throws IOException {
        return Files.readAllBytes(folder.resolve(name));
    }

    private List<String> names() throws IOException {
        try (Stream<Path> files = Files.list(folder)) {
            return files.map(file -> file.getFileName().toString()).sorted().toList();
        }
    }

    @Test
    void mergedShardsAreTheBytesOfTheUnshardedPictureAndOfItsError() throws IOException {
        traced("whole.pfm", "--error", out("whole-se.pfm"));
        for (int number = 1; number <= 3; number++) {
            traced("f.pfm", "--shard", number + "/3");
        }
        assertFalse(Files.exists(folder.resolve("f.pfm")), "a shard is no picture");
        done(
                "render",
                "--merge",
                out("f.pfm.3-of-3.part"),
                out("f.pfm.1-of-3.part"),
                out("f.pfm.2-of-3.part"),
                "--out",
                out("merged.pfm"),
                "--error",
                out("merged-se.pfm"));
        assertArrayEquals(bytes("whole.pfm"), bytes("merged.pfm"));
        assertArrayEquals(bytes("whole-se.pfm"), bytes("merged-se.pfm"));
        assertEquals(Files.size(folder.resolve("whole.pfm")), Files.size(folder.resolve("whole-se.pfm")));
        assertTrue(names().contains("f.pfm.1-of-3.part"), "parts stay until their user deletes them");
        assertFalse(names().contains("whole.pfm.part"));
    }

    @Test
    void aKilledRunGoesOnToTheBytesOfAnUninterruptedOne() throws IOException {
        // Six tiles of one size: whichever a thread finishes first, half of the bytes hold two of them.
        String[] size = {"--size", "48x32"};
        traced("whole.pfm", size);
        // All tiles of the picture are in the part of its only shard; what a killed run leaves is a beginning of it.
        traced("w.pfm", "--shard", "1/1", "--size", "48x32");
        byte[] all = bytes("w.pfm.1-of-1.part");
        Files.write(folder.resolve("again.pfm.part"), Arrays.copyOf(all, all.length / 2));
        Captured answer = traced("again.pfm", size);
        assertTrue(answer.err().contains("resumed at 33 %"), answer.err());
        assertArrayEquals(bytes("whole.pfm"), bytes("again.pfm"));
        assertFalse(Files.exists(folder.resolve("again.pfm.part")), "a finished picture needs no part");
    }

    @Test
    void aPartOfAnotherPictureIsReplacedAndItIsSaid() throws IOException {
        traced("whole.pfm");
        traced("w.pfm", "--shard", "1/1", "--seed", "8");
        Files.copy(folder.resolve("w.pfm.1-of-1.part"), folder.resolve("again.pfm.part"));
        Captured answer = traced("again.pfm");
        assertTrue(answer.err().contains("again.pfm.part was of another picture: seed 8, not 7"), answer.err());
        assertArrayEquals(bytes("whole.pfm"), bytes("again.pfm"));
    }

    @ParameterizedTest
    @ValueSource(strings = {"--spp 41", "--seed 9", "--size 41x24", "--time 5", "--fov 60 --eye 0,0,0 --target 0,0,-2"})
    void partsOfAnotherPictureAreRefusedWithTheirName(String option) throws IOException {
        traced("f.pfm", "--shard", "1/2");
        traced(
                "f.pfm",
                Stream.concat(Stream.of("--shard", "2/2"), Stream.of(option.split(" ")))
                        .toArray(String[]::new));
        refusedToMerge("f.pfm.2-of-2.part: belongs to another picture than");
    }

    @Test
    void partsOfAnotherLevelAreRefusedWithTheirName() throws IOException {
        traced("f.pfm", "--shard", "1/2");
        Files.writeString(folder.resolve("level.json"), LEVEL.replace("0.05", "0.06"));
        traced("f.pfm", "--shard", "2/2");
        refusedToMerge("level ");
    }

    private void refusedToMerge(String because) throws IOException {
        Captured answer = Captured.run(
                "render", "--merge", out("f.pfm.1-of-2.part"), out("f.pfm.2-of-2.part"), "--out", out("m.pfm"));
        assertEquals(1, answer.exitCode(), answer.err());
        assertTrue(answer.err().contains("f.pfm.2-of-2.part") && answer.err().contains(because), answer.err());
        assertFalse(names().contains("m.pfm"));
    }

    @Test
    void aMissingOrUnreadablePartIsNamed() {
        traced("f.pfm", "--shard", "1/2");
        Captured one = Captured.run("render", "--merge", out("f.pfm.1-of-2.part"), "--out", out("m.pfm"));
        assertEquals(1, one.exitCode());
        assertTrue(one.err().contains("f.pfm.1-of-2.part: is one of 2 shards; missing: 2/2"), one.err());
        Captured none = Captured.run("render", "--merge", out("absent.part"), "--out", out("m.pfm"));
        assertEquals(1, none.exitCode());
        assertTrue(none.err().contains("absent.part: there is no such file; name the parts"), none.err());
        Captured folded = Captured.run("render", "--merge", folder.toString(), "--out", out("m.pfm"));
        assertEquals(3, folded.exitCode());
        assertTrue(folded.err().contains(folder + ": can't be read: "), folded.err());
    }

    @Test
    void whatCannotBeMeantIsRefusedAsWrongUsage() throws IOException {
        String[][] refused = {
            {"render", level, "--out", out("a.pfm"), "--shard", "1/2"},
            {"render", level, "--out", out("a.png"), "--reference", "--shard", "1/2"},
            {"render", level, "--out", out("a.pfm"), "--reference", "--shard", "0/2"},
            {"render", level, "--out", out("a.pfm"), "--reference", "--shard", "half"},
            {"render", level, "--out", out("a.pfm"), "--reference", "--shard", "1/2", "--error", out("e.pfm")},
            {"render", level, "--out", out("a.pfm"), "--error", out("e.pfm")},
            {"render", level, "--out", out("a.pfm"), "--reference", "--error", out("e.png")},
            {"render", level, "--out", out("a.pfm"), "--reference", "--error", out("a.pfm")},
            {"render", level, "--out", out("a.pfm"), "--reference", "--error", out("e.pfm"), "--spp", "31"},
            {"render", level, "--out", out("a.pfm"), "--reference", "--merge", out("p.part")},
            {"render", level, "--out", out("a.pfm"), "--merge", out("p.part")},
            {"render", "--out", out("a.png"), "--merge", out("p.part")},
            {"render", "--out", out("a.pfm"), "--merge", out("p.part"), "--spp", "4"},
            {"render", level, "--out", out("a.pfm"), "--reference", "--spp", "0"},
        };
        for (String[] words : refused) {
            Captured answer = Captured.run(words);
            assertEquals(2, answer.exitCode(), List.of(words) + " " + answer.err());
            assertFalse(answer.err().isBlank(), List.of(words).toString());
        }
        assertEquals(List.of("level.json"), names());
    }
}
