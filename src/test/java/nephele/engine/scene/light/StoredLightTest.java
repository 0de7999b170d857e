package nephele.engine.scene.light;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import nephele.engine.asset.LevelAssets;
import nephele.engine.level.json.LevelFile;
import nephele.engine.level.placed.PlacedLevel;
import nephele.engine.scene.light.StoredLight.State;
import nephele.engine.scene.light.bake.BakedLight;
import nephele.engine.scene.light.bake.IndirectLight;
import nephele.engine.scene.light.bake.IndirectLight.Course;
import nephele.engine.scene.light.bake.IndirectLight.Layer;
import nephele.engine.scene.light.bake.IndirectLight.SkyLight;
import nephele.engine.scene.light.bake.LightKey;
import nephele.engine.scene.light.bake.LightMapLayout;
import nephele.engine.scene.light.bake.LightSamples;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Baked light on disk is drawn only with the very level that it was baked for. */
class StoredLightTest {
    private static final String LEVEL =
            """
            {"format": "nephele-level", "version": 1, "name": "Room",
             "environment": {"exposureStops": 1, "fog": {"extinctionPerMetre": 0.01, "radiance": [0, 0, 1]}},
             "player": {"feet": [0, 1, 0]},
             "cameras": [{"id": "eye", "position": [0, 2, 5], "target": [0, 0, 0]}],
             "materials": [
               {"id": "unused", "baseColour": [1, 0, 0]},
               {"id": "wall", "baseColour": [0.5, 0.5, 0.25], "texture": "brick.png"}],
             "solids": [
               {"id": "floor", "kind": "box", "centre": [0, 0, 0], "size": [8, 1, 8], "material": "wall"},
               {"id": "block", "kind": "box", "centre": [0, 1, 0], "size": [1, 1, 1], "material": "wall",
                "faces": {"+y": {"portalable": true}, "-y": {"material": "unused"}}}],
             "lights": [{"id": "lamp", "kind": "point", "position": [0, 3, 0], "radiantIntensity": [1, 2, 3]}]}
            """;

    private static final long SHIPPED_BYTES = 16 << 20;

    @TempDir
    private Path folder;

    private Path level() {
        return folder.resolve("room.json");
    }

    private PlacedLevel placed(String text) throws IOException {
        Files.writeString(level(), text);
        return PlacedLevel.of(LevelFile.read(level()), LevelAssets.beside(level()));
    }

    private PlacedLevel placed() throws IOException {
        Files.write(folder.resolve("brick.png"), new byte[] {1, 2, 3});
        return placed(LEVEL);
    }

    private static IndirectLight light(PlacedLevel placed) {
        LightMapLayout layout = LightMapLayout.of(placed.statics().solids());
        LightSamples texels = LightSamples.black(layout.width() * layout.height());
        texels.radiance()[0] = 1;
        return new IndirectLight(
                SkyLight.BAKED, List.of(new Layer("", Course.INDIRECT, texels, LightSamples.black(0), List.of())));
    }

    private Path baked(PlacedLevel placed) throws IOException {
        Path file = folder.resolve("baked").resolve(LightKey.of(placed).fileName());
        Files.createDirectories(file.getParent());
        Files.write(file, StoredLight.file(placed, light(placed)));
        return file;
    }

    private static State state(PlacedLevel placed) {
        return LevelLight.stored(placed).state();
    }

    @Test
    void lightIsReadAndWithoutAnyNothingIs() throws IOException {
        PlacedLevel placed = placed();
        assertEquals(State.MISSING, state(placed));
        assertNull(LevelLight.of(placed, done -> {}));
        Path file = baked(placed);
        BakedLight read = LevelLight.of(placed, done -> {});
        assertEquals(1, read.indirect().layers().get(0).texels().radiance()[0]);
        assertEquals(0, read.visibility().at(1, 1), "no sky shines");
        assertNotNull(LevelLight.known(placed).orElseThrow().indirect());
        assertEquals(
                "baked light: " + file.getFileName(), LevelLight.stored(placed).line("room.json"));
        assertTrue(LevelLight.stored(placed).warning("room.json").isEmpty());
    }

    @Test
    void whatIsThereAndIgnoredIsNamedOnce() throws IOException {
        PlacedLevel placed = placed();
        Path file = baked(placed);
        byte[] good = Files.readAllBytes(file);
        good[good.length - 9] ^= 1;
        Files.write(file, good);
        assertEquals(State.DAMAGED, state(placed));
        Files.write(file, "GIF89a".getBytes(StandardCharsets.US_ASCII));
        assertEquals(State.FOREIGN, state(placed));
        List<String> warnings = new ArrayList<>();
        assertNull(LevelLight.of(
                placed, done -> {}, stored -> stored.warning("room.json").ifPresent(warnings::add)));
        assertEquals(
                List.of("room.json: baked light: " + file.getFileName()
                        + " is no file of baked light and is ignored; `bake room.json --light` bakes it anew"),
                warnings);
    }

    @Test
    void lightOfAnEarlierVersionIsStaleAndThatOfAnotherLevelIsNothing() throws IOException {
        PlacedLevel placed = placed();
        Path file = baked(placed);
        PlacedLevel moved = placed(LEVEL.replace("[0, 3, 0]", "[0, 3, 1]"));
        assertEquals(State.STALE, state(moved));
        assertEquals(file.getFileName().toString(), LevelLight.stored(moved).file());
        Path other = folder.resolve("hall.json");
        Files.move(level(), other);
        assertEquals(State.MISSING, state(PlacedLevel.of(LevelFile.read(other), LevelAssets.beside(other))));
    }

    @Test
    void lightOfAnotherPictureIsStale() throws IOException {
        PlacedLevel placed = placed();
        baked(placed);
        Files.write(folder.resolve("brick.png"), new byte[] {1, 2, 4});
        assertEquals(State.STALE, state(placed));
        Files.delete(folder.resolve("brick.png"));
        assertEquals(State.STALE, state(placed));
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "\"name\": \"Room\"|\"name\": \"Hall\"",
                "\"exposureStops\": 1|\"exposureStops\": 2",
                "[0, 1, 0]}|[0, 1, 1]}",
                "[0, 2, 5]|[0, 2, 6]",
                "\"wall\"|\"stone\"",
                "\"lamp\"|\"sun\"",
                "\"block\"|\"step\"",
                "\"portalable\": true|\"portalable\": false",
                "\"materials\": [|\"materials\": [{\"id\": \"other\", \"baseColour\": [0, 1, 0]},",
            })
    void aNameOrAnEyeChangesNoKey(String before, String after) throws IOException {
        String edited = LEVEL.replace(before, after);
        assertNotEquals(LEVEL, edited);
        assertEquals(
                LightKey.of(placed()).fileName(), LightKey.of(placed(edited)).fileName());
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "\"extinctionPerMetre\": 0.01|\"extinctionPerMetre\": 0.02",
                "{\"exposureStops\": 1|{\"ambient\": [0, 0, 1]",
                "[0.5, 0.5, 0.25]|[0.5, 0.5, 0.26]",
                "\"baseColour\": [1, 0, 0]|\"baseColour\": [1, 0, 0.1]",
                "\"texture\": \"brick.png\"|\"texture\": \"stone.png\"",
                "\"texture\": \"brick.png\"|\"mirror\": true",
                "\"texture\": \"brick.png\"|\"texture\": \"brick.png\", \"emission\": [1, 1, 1]",
                "[1, 2, 3]|[1, 2, 4]",
                "\"kind\": \"point\"|\"kind\": \"point\", \"castsShadow\": false",
                "[8, 1, 8]|[8, 1, 8.01]",
                "\"-y\": {\"material\"|\"+x\": {\"material\"",
            })
    void whatLightDependsOnChangesTheKey(String before, String after) throws IOException {
        String edited = LEVEL.replace(before, after);
        assertNotEquals(LEVEL, edited);
        assertNotEquals(
                LightKey.of(placed()).fileName(), LightKey.of(placed(edited)).fileName());
    }

    @Test
    void shippedLevelsHaveTheirLight() throws IOException {
        try (var files = Files.list(Path.of("levels", "baked"))) {
            long bytes = files.mapToLong(file -> file.toFile().length()).sum();
            assertTrue(bytes <= SHIPPED_BYTES, bytes + " bytes of baked light");
        }
        try (var levels = Files.newDirectoryStream(Path.of("levels"), "[0-9][0-9]-*.json")) {
            for (Path level : levels) {
                PlacedLevel shipped = PlacedLevel.of(LevelFile.read(level), LevelAssets.beside(level));
                assertEquals(State.BAKED, state(shipped), () -> level + ": run `./nephele bake " + level + " --light`");
            }
        }
    }
}
