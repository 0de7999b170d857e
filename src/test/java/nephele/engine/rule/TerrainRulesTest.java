package nephele.engine.rule;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.stream.Stream;
import nephele.engine.asset.AssetSource;
import nephele.engine.asset.LayerMap;
import nephele.engine.asset.TestAssets;
import nephele.engine.level.Level;
import nephele.engine.level.Problem;
import nephele.engine.level.Terrain;
import nephele.engine.level.Terrain.Layer;
import nephele.engine.level.TestLevel;
import nephele.engine.level.TestTerrain;
import nephele.engine.math.Vec3;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;

class TerrainRulesTest {
    private static final TestAssets MAP = TestTerrain.map(5, TestTerrain::wavy);

    private static List<Problem> problems(AssetSource assets, Terrain terrain) {
        Level level = new TestLevel()
                .material("a", new Vec3(1, 0, 0))
                .material("b", new Vec3(0, 1, 0))
                .level()
                .withTerrains(List.of(terrain));
        return LevelRules.checkRecordsAndFiles(level, assets).stream()
                .filter(problem -> problem.path().startsWith("terrains"))
                .toList();
    }

    private static Layer layer(double from, double to, double blend, double least, double most) {
        return new Layer("a", from, to, blend, least, most);
    }

    private static Layer all() {
        return Layer.everywhere("a");
    }

    static Stream<Arguments> wrong() {
        return Stream.of(
                Arguments.of("layers[0].material: ", "no material", List.of(Layer.everywhere("x"))),
                Arguments.of("layers[0].toMetres: ", "ends where it begins", List.of(layer(5, 5, 0, 0, 90), all())),
                Arguments.of("layers[1].maxSlopeDegrees: ", "no slope", List.of(all(), layer(0, 5, 0, 40, 40))),
                Arguments.of("layers[1].blendMetres: ", "never reaches", List.of(all(), layer(0, 5, 6, 0, 90))),
                Arguments.of("layers: ", "heights of 5 m to 10 m", List.of(layer(0, 5, 0, 0, 90))),
                Arguments.of("layers: ", "slopes of 30° to 90°", List.of(layer(-5, 50, 0, 0, 30))),
                Arguments.of("layers[1]: ", "equal shares", List.of(all(), layer(4, 6, 0, 0, 90))),
                Arguments.of("layers[1]: ", "above or below all", List.of(all(), layer(60, 70, 0, 0, 90))));
    }

    @ParameterizedTest
    @MethodSource("wrong")
    void layersThatAreWrongAreToldWithTheirPath(String path, String because, List<Layer> layers) {
        Terrain terrain = TestTerrain.said("t", "map.r16", layers.toArray(Layer[]::new));
        List<Problem> told = problems(MAP, terrain);
        assertEquals(1, told.size(), told::toString);
        assertTrue(("terrains[0]." + path).startsWith(told.get(0).path() + ": "), told::toString);
        assertTrue(told.get(0).message().contains(because), told::toString);
    }

    @Test
    void layersThatMeetAreRight() {
        Terrain terrain = TestTerrain.said(
                "t", "map.r16", layer(-1e7, 4, 1, 0, 30), layer(4, 1e7, 1, 0, 30), layer(-1e7, 1e7, 0, 30, 90));
        assertEquals(List.of(), problems(MAP, terrain));
        assertEquals(List.of(), problems(MAP, TestTerrain.said("t", "map.r16")));
    }

    @Test
    void aMissingOrBadMapIsToldAtEachTerrain() {
        List<Problem> missing = problems(TestAssets.NONE, TestTerrain.said("t", "map.r16"));
        assertEquals("terrains[0].heightMap", missing.get(0).path());
        TestAssets odd = new TestAssets().file("map.r16", new byte[7]);
        assertTrue(
                problems(odd, TestTerrain.said("t", "map.r16")).get(0).message().contains("7 bytes"));
    }

    /** 100 m in 255 steps of 0.39 m. */
    @Test
    void theStepsOfEightBitsAreToldIfTheyAreSeen() {
        TestAssets picture = new TestAssets().picture("map.png", 4, 4, (x, y) -> 0x010101 * (60 * x));
        Terrain low = TestTerrain.said("t", "map.png");
        assertEquals(List.of(), problems(picture, low));
        Terrain high = new Terrain(
                "t", "map.png", Vec3.ZERO, low.sizeMetres(), new Terrain.HeightRange(-20, 80), List.of(), false);
        List<Problem> told = problems(picture, high);
        assertTrue(told.get(0).message().contains("steps of 0.39 m"), told::toString);
        assertTrue(!told.get(0).isError());
    }

    @Test
    void aRawMapWithTheHighByteFirstIsTold() {
        Terrain said = TestTerrain.said("t", "map.r16");
        assertEquals(List.of(), problems(TestTerrain.map(33, TestTerrain::wavy), said));
        TestAssets swapped = TestTerrain.map(33, (x, y) -> Short.reverseBytes((short) TestTerrain.wavy(x, y)));
        List<Problem> told = problems(swapped, said);
        assertEquals(
                List.of("terrains[0].heightMap: warning: map.r16 is as rough as noise, and would be smooth with the"
                        + " two bytes of each number exchanged: write it with the low byte first"),
                told.stream().map(problem -> problem.line("").substring(2)).toList());
    }

    @Test
    void aRangeThatIsUpsideDownIsAnError() {
        Terrain said = TestTerrain.said("t", "map.r16");
        Terrain turned = new Terrain(
                "t", "map.r16", Vec3.ZERO, said.sizeMetres(), new Terrain.HeightRange(3, 2), List.of(), false);
        assertEquals(
                "terrains[0].heightRangeMetres", problems(MAP, turned).get(0).path());
        Terrain flat = new Terrain(
                "t", "map.r16", Vec3.ZERO, said.sizeMetres(), new Terrain.HeightRange(-2, -2), List.of(all()), true);
        assertEquals(List.of(), problems(MAP, flat));
    }

    private static LayerMap painted(int layer) {
        return new LayerMap(2, 2, new byte[] {0, 9, 0, 0, (byte) layer, 1, 99, 0});
    }

    @Test
    void aLayerMapMustBeReadableAndNameLayersThatExist() {
        Terrain said = TestTerrain.said("t", "map.r16", layer(-1e7, 4, 0, 0, 90), layer(4, 1e7, 0, 0, 90))
                .withLayerMap("layers.png");
        List<Problem> missing = problems(MAP, said);
        assertEquals("terrains[0].layerMap", missing.get(0).path());
        TestAssets assets = TestTerrain.map(5, TestTerrain::wavy);
        assertEquals(List.of(), problems(assets.file("layers.png", painted(1).png()), said));
        List<Problem> beyond = problems(assets.file("layers.png", painted(2).png()), said);
        assertEquals("terrains[0].layerMap", beyond.get(0).path());
        assertTrue(
                beyond.get(0)
                        .message()
                        .contains("layers.png: paints layer 2 at pixel (0, 1), and 't' has layers 0 to 1"),
                beyond::toString);
        assertTrue(problems(assets, said.withLayers(List.of()).withLayerMap("layers.png"))
                .get(0)
                .message()
                .contains("has no layers"));
    }

    @Test
    void aLayerBeyondAllHeightsMayBePainted() {
        Terrain said = TestTerrain.said("t", "map.r16", all(), layer(60, 70, 0, 0, 90));
        TestAssets assets = TestTerrain.map(5, TestTerrain::wavy)
                .file("layers.png", painted(1).png());
        assertEquals(1, problems(assets, said).size());
        assertEquals(List.of(), problems(assets, said.withLayerMap("layers.png")));
    }

    @Test
    void aPortalOnATerrainIsNotInFreeSpace() {
        Terrain ground = TestTerrain.said("t", "map.r16");
        assertEquals(0, freePortals(ground, ground.heightRangeMetres().high()));
        assertEquals(2, freePortals(ground, ground.heightRangeMetres().high() + 0.1));
    }

    private static long freePortals(Terrain ground, double height) {
        Level level = new TestLevel()
                .box("m", new Vec3(900, 0, 0), new Vec3(1, 1, 1))
                .portal("a", "b", new Vec3(1, height, 0), new Vec3(0, 1, 0), 1, 2)
                .portal("b", "a", new Vec3(-1, height, 0), new Vec3(0, 1, 0), 1, 2)
                .level()
                .withTerrains(List.of(ground));
        return LevelRules.checkRecordsAndFiles(level, MAP).stream()
                .filter(problem -> problem.message().contains("free space"))
                .count();
    }
}
