package nephele.engine.level.placed;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.charset.StandardCharsets;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import nephele.engine.asset.AssetException;
import nephele.engine.asset.AssetSource;
import nephele.engine.level.Level;
import nephele.engine.level.ModelPlacement;
import nephele.engine.level.ModelPlacement.TransformStep;
import nephele.engine.level.ModelPlacement.TransformStep.Rotate;
import nephele.engine.level.ModelPlacement.TransformStep.Scale;
import nephele.engine.level.ModelPlacement.TransformStep.Translate;
import nephele.engine.level.Problem;
import nephele.engine.level.appearance.ColourDecoding;
import nephele.engine.level.json.LevelJson;
import nephele.engine.math.Basis;
import nephele.engine.math.Vec3;
import nephele.engine.model.Mesh;
import nephele.engine.reference.Pinhole;
import nephele.engine.reference.TracedLevel;
import nephele.engine.rule.LevelRules;
import nephele.engine.scene.Scene;
import nephele.engine.scene.light.LevelLight;
import nephele.engine.sim.state.SimLevel;
import org.joml.Matrix4d;
import org.joml.Vector3d;
import org.junit.jupiter.api.Assertions;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Models have the right pose, orientation, solidity and number in the world. */
@Execution(ExecutionMode.CONCURRENT)
class PlacedModelsTest {
    private static ModelPlacement model(String id, String file, String parent, TransformStep... steps) {
        return new ModelPlacement(id, file, parent, List.of(steps), null, false);
    }

    private static Level level(List<ModelPlacement> models) {
        Level empty = read("");
        return empty.with(List.of(), List.of(), List.of(), models);
    }

    private static Level read(String sections) {
        String text = "{\"format\": \"nephele-level\", \"version\": 1" + sections + "}";
        return LevelJson.read("f", text.getBytes(StandardCharsets.UTF_8));
    }

    private static PlacedModel only(String file, TransformStep... steps) {
        return PlacedModels.of(level(List.of(model("m", file, null, steps))), NoFiles.AT_ALL)
                .all()
                .get(0);
    }

    /** The first step is the outermost, and a parent is outside all steps. */
    @Test
    void stepsApplyInTheirOrder() {
        var turn = new Rotate(new Vec3(0, 2, 0), 90);
        var move = new Translate(new Vec3(1, 2, 3));
        var grow = new Scale(new Vec3(2, -3, 4));
        List<ModelPlacement> models = List.of(
                model("child", "a", "parent", grow),
                model("parent", "a", null, move, turn),
                model("reversed", "a", null, turn, move));
        var frames = PlacedModels.ModelFrames.of(models);
        assertPlace(new Vec3(1 + 4, 2 - 3, 3 - 2), frames.get(0).transformPosition(new Vector3d(1, 1, 1)));
        assertPlace(new Vec3(1 + 1, 2, 3), frames.get(1).transformPosition(new Vector3d(0, 0, 1)));
        assertPlace(new Vec3(3 + 1, 2, -1), frames.get(2).transformPosition(new Vector3d(0, 0, 1)));
    }

    private static void assertPlace(Vec3 expected, Vector3d found) {
        assertEquals(0, found.distance(expected.x(), expected.y(), expected.z()), 1e-12, found::toString);
    }

    /** The last of ten thousand models in a chain, with children before their parents, is posed. */
    @Test
    void aLongChainOfParentsIsWalkedOnce() {
        List<ModelPlacement> chain = new ArrayList<>();
        for (int i = 9_999; i >= 0; i--) {
            String parent = i == 0 ? null : "m" + (i - 1);
            chain.add(model(
                    "m" + i, "a", parent, new Translate(new Vec3(0.25, 0, 0)), new Rotate(new Vec3(1, 0, 0), 90)));
        }
        Assertions.assertTimeout(Duration.ofSeconds(2), () -> {
            Vector3d end = PlacedModels.ModelFrames.of(chain).get(0).transformPosition(new Vector3d());
            assertEquals(2500, end.x, 1e-9);
        });
    }

    @Test
    void whatHangsNowhereIsRefused() {
        assertThrows(IllegalArgumentException.class, () -> PlacedModels.ModelFrames.of(List.of(model("a", "x", "b"))));
        List<ModelPlacement> circle = List.of(model("a", "x", "b"), model("b", "x", "c"), model("c", "x", "a"));
        assertThrows(IllegalArgumentException.class, () -> PlacedModels.ModelFrames.of(circle));
    }

    /** Every triangle faces outwards, as its normals do, under every kind of scale. */
    @ParameterizedTest
    @CsvSource({"1,1,1", "-1,1,1", "2,-0.1,3", "-1,-1,1", "-0.5,-2,-3", "1e-6,1e-6,-1e-6", "1000,0.001,-1"})
    void trianglesAndNormalsLookOutward(double x, double y, double z) {
        WorldTriangles ball = only("sphere_1_12_8.3d", new Rotate(new Vec3(1, 1, 0), 30), new Scale(new Vec3(x, y, z)))
                .triangles();
        assertEquals(12 * 8 * 2 - 2 * 12, ball.count(), "without those that are a point wide at the poles");
        for (int triangle = 0; triangle < ball.count(); triangle++) {
            Vec3 place = ball.corner(triangle, 1);
            Vec3 face = ball.faceNormal(triangle);
            assertTrue(face.dot(place) > 0, "triangle " + triangle);
            for (int corner = 0; corner < 3; corner++) {
                Vec3 normal = ball.normal(triangle, corner);
                assertEquals(1, normal.length(), 1e-12);
                assertTrue(normal.dot(face) > 0, "triangle " + triangle);
            }
        }
    }

    @ParameterizedTest
    @CsvSource({"box_2_1.3d,6", "box_1_5.3d,6", "sphere_1_8_8.3d,64", "cone_1_2_7_3.3d,8", "cylinder_1_2_20.3d,22"})
    void closedConvexMeshesAreSolids(String file, int faces) {
        for (double sign : new double[] {1, -1}) {
            PlacedModel model = only(
                    file,
                    new Translate(new Vec3(1000, 3, -2000)),
                    new Rotate(new Vec3(1, 2, 3), 33),
                    new Scale(new Vec3(2, sign * 0.3, 1)));
            assertNotNull(model.solid(), file);
            assertEquals(faces, model.solid().faces().size());
        }
    }

    @ParameterizedTest
    @ValueSource(strings = {"plane_2_3.3d", "torus_1_0.3_12_8.3d", "bezier_3.3d", "sphere_1_40_40.3d"})
    void otherMeshesAreSheets(String file) {
        assertNull(only(file).solid());
    }

    /** A tube, whose hull would close it, a box with a hole, and two sides of one plane are no solids. */
    @Test
    void whatIsOpenIsNoSolid() {
        Mesh box = new MeshAssets(NoFiles.AT_ALL).mesh("box_2_1.3d");
        assertNotNull(placed(box).solid());
        assertNull(placed(without(box, 1, 1)).solid(), "half a face is missing");
        for (int axis = 0; axis < 3; axis++) {
            Mesh tube = withoutFacing(box, axis);
            assertEquals(8, tube.triangleCount());
            assertNull(placed(tube).solid(), "a tube along axis " + axis);
        }
        Mesh flat = new Mesh(
                new float[] {0, 0, 0, 1, 0, 0, 0, 0, 1},
                new float[] {0, -1, 0, 0, -1, 0, 0, -1, 0},
                new float[6],
                new int[] {0, 1, 2, 2, 1, 0, 1, 2, 0, 0, 2, 1});
        assertNull(placed(flat).solid());
    }

    private static PlacedModel placed(Mesh mesh) {
        return PlacedModel.of(0, model("m", "m", null), mesh, new Matrix4d());
    }

    private static Mesh without(Mesh mesh, int firstTriangle, int count) {
        int[] indices = new int[mesh.indices().length - 3 * count];
        for (int i = 0; i < indices.length; i++) {
            indices[i] = mesh.indices()[i < 3 * firstTriangle ? i : i + 3 * count];
        }
        return new Mesh(mesh.positions(), mesh.normals(), mesh.textureCoordinates(), indices);
    }

    private static Mesh withoutFacing(Mesh mesh, int axis) {
        List<Integer> kept = new ArrayList<>();
        for (int at = 0; at < mesh.indices().length; at += 3) {
            if (Math.abs(mesh.normals()[3 * mesh.indices()[at] + axis]) < 0.5) {
                kept.addAll(List.of(mesh.indices()[at], mesh.indices()[at + 1], mesh.indices()[at + 2]));
            }
        }
        int[] indices = kept.stream().mapToInt(i -> i).toArray();
        return new Mesh(mesh.positions(), mesh.normals(), mesh.textureCoordinates(), indices);
    }

    @Test
    void trianglesThatAreNoneAreLeftOut() {
        Mesh flat = new Mesh(
                new float[] {0, 0, 0, 1, 0, 0, 2, 0, 0, 0, 1, 0},
                new float[] {0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, -1},
                new float[8],
                new int[] {0, 1, 2, 0, 0, 3, 0, 2, 3});
        WorldTriangles mesh = WorldTriangles.of(flat, new Matrix4d());
        assertEquals(1, mesh.count());
        assertEquals(new Vec3(0, 0, 1), mesh.normal(0, 2), "a normal that points behind its triangle");
    }

    private static List<Problem> problems(Map<String, byte[]> files, String models) {
        return LevelRules.checkRecordsAndFiles(read(", \"models\": [" + models + "]"), new NoFiles(files)).stream()
                .filter(Problem::isError)
                .toList();
    }

    private static void assertProblem(List<Problem> problems, String path, String... parts) {
        assertEquals(1, problems.size(), problems::toString);
        assertEquals(path, problems.get(0).path());
        for (String part : parts) {
            assertTrue(problems.get(0).message().contains(part), problems.get(0).message());
        }
    }

    @Test
    void problemsNameFileLineAndPath() {
        assertProblem(
                problems(Map.of(), "{\"id\": \"a\", \"file\": \"a.obj\"}"), "models[0].file", "a.obj", "no such file");
        Map<String, byte[]> broken = Map.of("a.obj", "v 0 0 0\nv 1 0 0\nf 1 2 9\n".getBytes(StandardCharsets.UTF_8));
        assertProblem(problems(broken, "{\"id\": \"a\", \"file\": \"a.obj\"}"), "models[0].file", "a.obj:3");
        assertProblem(
                problems(Map.of(), "{\"id\": \"a\", \"file\": \"sphere_1_0_8.3d\"}"),
                "models[0].file",
                "sphere_1_0_8.3d");
        String far = "{\"kind\": \"scale\", \"by\": [1e4, 1, 1]}";
        assertProblem(
                problems(
                        Map.of(),
                        "{\"id\": \"a\", \"file\": \"box_1_1.3d\", \"transform\": [" + far + "," + far + "]}"),
                "models",
                "10 000 km");
        assertProblem(problems(Map.of(), "{\"id\": \"a\", \"file\": \"plane_1_400.3d\"}"), "models[0].file", "200000");
        AssetException thrown = assertThrows(AssetException.class, () -> only("gone.gltf"));
        assertTrue(thrown.getMessage().contains("gone.gltf"), thrown.getMessage());
    }

    /** At most two of a thousand different meshes are generated where a level may have one. */
    @Test
    void tooManyTrianglesAreNotAllMade() {
        StringBuilder models = new StringBuilder();
        for (int i = 0; i < 1000; i++) {
            models.append(i == 0 ? "" : ",")
                    .append("{\"id\": \"m" + i + "\", \"file\": \"sphere_" + (i + 1) + "_300_300.3d\"}");
        }
        Assertions.assertTimeout(
                Duration.ofSeconds(10), () -> assertProblem(problems(Map.of(), models.toString()), "models", "200000"));
    }

    /** Thousands of overlapping triangles, all of which rays and sweeps would test, are refused. */
    @Test
    void trianglesThatLieInEachOtherByThousandsAreRefused() {
        String model = "{\"id\": \"a\", \"file\": \"crowd.3d\"}";
        assertEquals(List.of(), problems(Map.of("crowd.3d", crowd(4_000, 0)), model));
        assertEquals(List.of(), problems(Map.of("crowd.3d", crowd(4_100, 2)), model));
        assertProblem(
                problems(Map.of("crowd.3d", crowd(4_100, 0)), model),
                "models",
                "crowd.3d",
                "meets 4100 others",
                "split its long triangles");
    }

    /** @param step offset from each triangle to the next, in side lengths */
    private static byte[] crowd(int triangles, int step) {
        StringBuilder rows = new StringBuilder();
        for (int i = 0; i < triangles; i++) {
            double x = step * i * 0.01;
            rows.append(String.format(Locale.ROOT, "%s 0 0\n%s 0 0\n%s 0.01 0\n", x, x + 0.01, x));
        }
        rows.append('\n');
        for (int i = 0; i < 3 * triangles; i += 3) {
            rows.append(i + " " + (i + 1) + " " + (i + 2) + "\n");
        }
        return rows.toString().getBytes(StandardCharsets.UTF_8);
    }

    private static List<String> told(String sections) {
        return LevelRules.checkRecordsAndFiles(read(", " + sections), NoFiles.AT_ALL).stream()
                .map(problem -> problem.path() + (problem.isError() ? "!" : ""))
                .toList();
    }

    @Test
    void aStartInsideAModelIsTold() {
        String player = "\"player\": {\"feet\": [0, 0, 0]}, \"models\": [{\"id\": \"a\", \"file\": ";
        assertEquals(List.of("player.feet!"), told(player + "\"box_1_1.3d\"}]"));
        assertEquals(List.of("player.feet!"), told(player + "\"sphere_1_8_8.3d\"}]"));
        assertEquals(List.of(), told(player + "\"torus_3_0.4_8_8.3d\"}]"), "in its hole");
    }

    @Test
    void aPortalMayLieOnAModel() {
        String start = "\"player\": {\"feet\": [0, 0, 9]}, \"models\": [{\"id\": \"a\", \"file\": \"plane_8_3.3d\","
            + " \"transform\": [{\"kind\": \"rotate\", \"axis\": [1, 0, 0], \"angleDegrees\": 90}]}], \"portals\": [";
        String size = "\"widthMetres\": 1, \"heightMetres\": 2}";
        String a = "{\"id\": \"a\", \"linkedTo\": \"b\", \"centre\": [2, 1, 0], \"normal\": [0, 0, 1]," + size;
        String b = "{\"id\": \"b\", \"linkedTo\": \"a\", \"centre\": [-2, 1, %s], \"normal\": [0, 0, %s]," + size;
        assertEquals(List.of(), told(start + a + "," + b.formatted("0.0005", "1") + "]"));
        assertEquals(List.of("portals[1].centre"), told(start + a + "," + b.formatted("0.002", "1") + "]"));
        assertEquals(List.of("portals[1].centre"), told(start + a + "," + b.formatted("0", "-1") + "]"));
    }

    /** Static shapes derived once serve scene, simulation and reference path tracer, without their files. */
    @Test
    void staticShapesThatWereBuiltOnceServeSceneSimulationAndOracle() {
        Level level = level(List.of(model("m", "box_1_1.3d", null, new Translate(new Vec3(0, 2, 0)))));
        StaticShapes statics = StaticShapes.of(level, NoFiles.AT_ALL);
        AssetSource unread = new AssetSource() {
            @Override
            public byte[] bytes(String assetId) {
                throw new AssertionError(assetId + " is read again");
            }

            @Override
            public boolean exists(String assetId) {
                return false;
            }
        };
        PlacedLevel placed = new PlacedLevel(level, unread, statics);
        assertSame(
                statics,
                placed.edited(level.with(level.environment(), List.of())).statics());
        assertSame(statics, Scene.of(placed, LevelLight.of(placed, done -> {})).statics());
        assertEquals(1, SimLevel.of(placed).statics().size());
        TracedLevel traced = TracedLevel.of(placed, ColourDecoding.SRGB);
        Basis ahead = new Basis(new Vec3(1, 0, 0), new Vec3(0, 1, 0), new Vec3(0, 0, 1));
        Pinhole eye = new Pinhole(new Vec3(0, 2, 9), ahead, 1, 1, 0.1, 100);
        assertEquals(0, traced.sight(eye).at(0.5, 0.5));
    }

    /** The greatest number of models of a level, each with twelve triangles, is drawn and solid. */
    @Test
    void tenThousandModelsLoadInSeconds() {
        List<ModelPlacement> models = new ArrayList<>();
        for (int i = 0; i < 10_000; i++) {
            models.add(
                    model("m" + i, "box_1_1.3d", null, new Translate(new Vec3(2.0 * (i % 100), 0, 2.0 * (i / 100)))));
        }
        Level level = level(models);
        Assertions.assertTimeout(Duration.ofSeconds(20), () -> {
            assertEquals(10_000, Scene.of(level, NoFiles.AT_ALL).solids().slotCount());
            assertEquals(
                    10_000,
                    SimLevel.of(PlacedLevel.of(level, NoFiles.AT_ALL)).statics().size());
        });
    }
}
