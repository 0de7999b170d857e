package nephele.app.command;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.channels.FileChannel;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.List;
import java.util.stream.Stream;
import nephele.engine.asset.LevelAssets;
import nephele.engine.asset.PictureDecoder;
import nephele.engine.level.Environment;
import nephele.engine.level.Level;
import nephele.engine.level.Sky;
import nephele.engine.level.appearance.CelestialPositions;
import nephele.engine.level.appearance.ColourDecoding;
import nephele.engine.level.appearance.Daylight;
import nephele.engine.level.appearance.SkyRadiance;
import nephele.engine.level.json.LevelFile;
import nephele.engine.math.Vec3;
import org.joml.Vector3d;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;

@Execution(ExecutionMode.CONCURRENT)
class BakeCommandTest {
    private static final String GRADIENT =
            "{\"kind\": \"gradient\", \"zenith\": [0.1, 0.2, 0.9], \"horizon\": [0.7, 0.6, 0.5], \"ground\": [0.2,"
                    + " 0.1, 0]}";

    @TempDir
    Path folder;

    private Path level(String sky) throws IOException {
        return Files.writeString(
                folder.resolve("level.json"),
                "{\"format\": \"nephele-level\", \"version\": 1, \"environment\": {" + sky + "}, \"solids\": ["
                        + "{\"kind\": \"box\", \"id\": \"floor\", \"centre\": [0, 0, 0], \"size\": [2, 1, 2]}]}");
    }

    private static SkyRadiance sky(Path file) {
        Level level = LevelFile.read(file);
        LevelAssets assets = LevelAssets.beside(file);
        return SkyRadiance.of(
                        level.environment(), id -> PictureDecoder.decode(id, assets.bytes(id)), ColourDecoding.SRGB)
                .orElseThrow();
    }

    private List<String> names() throws IOException {
        try (Stream<Path> files = Files.list(folder)) {
            return files.map(file -> file.getFileName().toString()).sorted().toList();
        }
    }

    @Test
    void theBakedSkyIsTheSkyOfTheLevelInEveryDirection() throws IOException {
        Path from = level("\"sky\": " + GRADIENT);
        Captured answer = Captured.run("bake", from.toString(), "--sky", "even", "--face-size", "64");
        assertEquals(0, answer.exitCode(), answer.err());
        Path to = folder.resolve("even.json");
        assertTrue(LevelFile.read(to).environment().sky() instanceof Sky.Skybox);
        assertEquals(LevelFile.read(from).solids(), LevelFile.read(to).solids());
        for (int i = 0; i < 200; i++) {
            double y = 1 - (i + 0.5) / 100;
            double r = Math.sqrt(1 - y * y);
            double x = r * Math.cos(2.4 * i);
            double z = r * Math.sin(2.4 * i);
            Vector3d expected = sky(from).from(x, y, z);
            Vector3d found = sky(to).from(x, y, z);
            assertEquals(0, expected.sub(found).length(), 0.02, "towards " + x + " " + y + " " + z);
        }
    }

    @Test
    void anAtmosphereIsBakedWithTheSunThatItsAirLeaves() throws IOException {
        Path from = level("\"sky\": {\"kind\": \"atmosphere\", \"timeOfDayHours\": 6}");
        assertEquals(
                0,
                Captured.run("bake", from.toString(), "--sky", "six", "--face-size", "8", "--spp", "1")
                        .exitCode());
        Level baked = LevelFile.read(folder.resolve("six.json"));
        assertTrue(baked.environment().sun().irradiance().x() < 4, "dimmed");
        assertTrue(
                baked.environment().sun().irradiance().z()
                        < baked.environment().sun().irradiance().x(),
                "and warm");
        assertNull(LevelFile.read(from).environment().sun(), "the level itself is as it was");
    }

    private static final String FLAT_SUN = "\"sun\": {\"directionTowardsSun\": [0, 1, 0], \"irradiance\": [2, 1, 0.5]}";

    @Test
    void cloudsAreInThePicturesAndDimTheSunOfTheirLevel() throws IOException {
        Path from = level(FLAT_SUN + ", \"sky\": {\"kind\": \"constant\", \"radiance\": [0.8, 0.8, 0.8]}, \"clouds\":"
                + " [{\"id\": \"soot\", \"kind\": \"layer\", \"baseAltitudeMetres\": 500, \"thicknessMetres\": 1000,"
                + " \"extinctionPerMetre\": 0.001, \"albedo\": 0}]");
        Captured answer = Captured.run("bake", from.toString(), "--sky", "soot", "--face-size", "8", "--spp", "256");
        assertEquals(0, answer.exitCode(), answer.err());
        Path to = folder.resolve("soot.json");
        Level baked = LevelFile.read(to);
        assertEquals(List.of(), baked.environment().clouds());
        double passed = Math.exp(-1);
        assertEquals(2 * passed, baked.environment().sun().irradiance().x(), 0.01);
        assertEquals(0.5 * passed, baked.environment().sun().irradiance().z(), 0.003);
        assertTrue(answer.out().contains("clouds let 0.3"), answer.out());
        assertEquals(0.8, sky(to).from(0, -1, 0).x, 0.01, "below the eye are no clouds");
        assertEquals(0.8 * passed, sky(to).from(0, 1, 0).x, 0.06, "overhead is the layer");
        assertTrue(sky(to).from(1, 0.13, 0).x < 0.05, "and a long way through it beside");
        assertTrue(names().stream().noneMatch(name -> name.endsWith(".part")), names().toString());
    }

    @Test
    void aBakedWeatherIsNotAddedAgain() throws IOException {
        Path from = level("\"sky\": {\"kind\": \"constant\", \"radiance\": [0.5, 0.5, 0.5]}, \"weather\": \"overcast\","
                + " \"weatherSeed\": 3");
        assertEquals(
                0,
                Captured.run("bake", from.toString(), "--sky", "grey", "--face-size", "2", "--spp", "1")
                        .exitCode());
        Level baked = LevelFile.read(folder.resolve("grey.json"));
        assertNull(baked.environment().weather());
        assertEquals(0, baked.environment().weatherSeed());
    }

    @Test
    void anInterruptedBakeGoesOnToTheSamePictures() throws IOException {
        Path from =
                level(FLAT_SUN + ", \"sky\": " + GRADIENT + ", \"clouds\": [{\"id\": \"puff\", \"kind\": \"volume\","
                        + " \"centre\": [0, 50, -100], \"size\": [80, 60, 80], \"extinctionPerMetre\": 0.1}]");
        String[] words = {"bake", from.toString(), "--sky", "puff", "--face-size", "24", "--spp", "2"};
        // A folder in the way of the last picture stops the bake when everything is traced.
        Path blocked = Files.createDirectories(folder.resolve("puff-nz.png").resolve("in-the-way"));
        assertEquals(3, Captured.run(words).exitCode());
        byte[] first = Files.readAllBytes(folder.resolve("puff-px.png"));
        Path part = folder.resolve("puff-px.part");
        try (var file = FileChannel.open(part, StandardOpenOption.WRITE)) {
            file.truncate(Files.size(part) - 5);
        }
        Files.delete(blocked);
        Files.delete(blocked.getParent());
        Captured answer = Captured.run(words);
        assertEquals(0, answer.exitCode(), answer.err());
        assertTrue(answer.err().contains("resumed at 95 %"), answer.err());
        assertArrayEquals(first, Files.readAllBytes(folder.resolve("puff-px.png")));
    }

    @Test
    void itSaysWhatEightBitsClip() throws IOException {
        Path from = level("\"sky\": {\"kind\": \"constant\", \"radiance\": [3, 0, 0]}");
        Captured answer = Captured.run("bake", from.toString(), "--sky", "red", "--face-size", "2");
        assertTrue(
                answer.out().contains("clip 24 of 24 pixels at 1.00 (100.00 %; the brightest has 3.00), 67 %"),
                answer.out());
        Captured dark = Captured.run(
                "bake",
                level("\"sky\": {\"kind\": \"constant\", \"radiance\": [1e-5, 0, 0]}")
                        .toString(),
                "--sky",
                "dark",
                "--face-size",
                "2");
        assertTrue(dark.out().contains("at 0.000122"), "white of a dark sky: " + dark.out());
        assertTrue(dark.out().contains("; 0.00 % of the pixels are darker"), dark.out());
        assertEquals(1e-5, sky(folder.resolve("dark.json")).from(0, 0, 1).x, 2e-7);
    }

    /** A night is baked with its own white, so that 8 bits hold its glow, and with its moon. */
    @Test
    void aNightIsBakedWithItsMoon() throws IOException {
        Path from = level("\"sky\": {\"kind\": \"atmosphere\", \"dayOfYear\": 20, \"timeOfDayHours\": 23.5}");
        Captured answer = Captured.run("bake", from.toString(), "--sky", "night", "--face-size", "10", "--spp", "1");
        assertEquals(0, answer.exitCode(), answer.err());
        Environment night = Daylight.lit(LevelFile.read(from)).environment();
        SkyRadiance seen = sky(folder.resolve("night.json"));
        SkyRadiance air = SkyRadiance.of(night, id -> null, ColourDecoding.SRGB).orElseThrow();
        Vec3 moon = CelestialPositions.towardsMoon((Sky.Atmosphere) night.sky());
        double share = seen.from(moon.x(), moon.y(), moon.z()).y / air.from(moon.x(), moon.y(), moon.z()).y;
        assertTrue(share > 1.15, "the moon is in a pixel that is much larger: " + share);
        for (int i = 0; i < 30; i++) {
            double y = 1 - (i + 0.5) / 15;
            double r = Math.sqrt(1 - y * y);
            double expected = air.from(r * Math.cos(2.4 * i), y, r * Math.sin(2.4 * i)).y;
            double found = seen.from(r * Math.cos(2.4 * i), y, r * Math.sin(2.4 * i)).y;
            assertTrue(found > 0.7 * expected && found < 1.3 * expected, i + ": " + found + ", not " + expected);
        }
    }

    @Test
    void whatCannotBeBakedIsRefusedAndNothingIsWritten() throws IOException {
        Path bright = level("\"sky\": " + GRADIENT);
        byte[] before = Files.readAllBytes(bright);
        String[][] refused = {
            {"bake", bright.toString()},
            {"bake", bright.toString(), "--sky", "../up"},
            {"bake", bright.toString(), "--sky", "level"},
            {"bake", bright.toString(), "--sky", "a", "--face-size", "0"},
            {"bake", bright.toString(), "--sky", "a", "--spp", "0"},
            {"bake", bright.toString(), bright.toString(), "--sky", "a"},
            {"bake", bright.toString(), "--sky", "a", "--light-error", "5"},
            {"bake", bright.toString(), "--light", "--light-error", "0"},
        };
        for (String[] words : refused) {
            assertEquals(2, Captured.run(words).exitCode(), List.of(words).toString());
        }
        assertArrayEquals(before, Files.readAllBytes(bright));
        Captured black = Captured.run("bake", level("\"exposureStops\": 0").toString(), "--sky", "a");
        assertTrue(black.exitCode() != 0 && black.err().contains("environment.sky"), black.err());
        assertEquals(List.of("level.json"), names());
    }

    @Test
    void lightIsBakedOnceAndWhatNoLevelNeedsIsDeleted() throws IOException {
        Path lit = level("\"sky\": " + GRADIENT);
        Path stale = Files.write(
                Files.createDirectories(folder.resolve("baked")).resolve("sky-visibility-0.bin"), new byte[3]);
        Captured first = Captured.run("bake", lit.toString(), "--light", "--light-error", "20");
        assertEquals(0, first.exitCode(), first.err());
        assertFalse(Files.exists(stale), first.out());
        try (Stream<Path> baked = Files.list(folder.resolve("baked"))) {
            assertEquals(2, baked.count());
        }
        assertTrue(
                Captured.run("explain", lit.toString()).out().contains("baked light: light-"),
                Captured.run("explain", lit.toString()).out());
        assertTrue(Captured.run("bake", lit.toString(), "--light").out().contains("baked already"));
    }
}
