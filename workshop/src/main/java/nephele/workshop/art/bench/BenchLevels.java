package nephele.workshop.art.bench;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.IntFunction;
import java.util.stream.IntStream;
import nephele.engine.level.Billboards;
import nephele.engine.level.Camera;
import nephele.engine.level.Environment;
import nephele.engine.level.Exposure;
import nephele.engine.level.Level;
import nephele.engine.level.Material;
import nephele.engine.level.ModelPlacement;
import nephele.engine.level.Sky;
import nephele.engine.level.SkyboxLayout;
import nephele.engine.level.Solid;
import nephele.engine.level.Sun;
import nephele.engine.level.TextureMapping;
import nephele.engine.level.ToneCurve;
import nephele.engine.math.Vec3;

/**
 * The benchmark scenes as levels: clear, skybox, boxes, billboards, portals, bodies, terrain and forests. The engines that
 * Nephele is compared with draw the same scenes, except for the forests.
 */
public final class BenchLevels {
    private static final Vec3 ONE = new Vec3(1, 1, 1);
    private static final Vec3 UP = new Vec3(0, 1, 0);
    private static final Sky CLEAR_COLOUR = new Sky.Constant(new Vec3(0.4, 0.6, 0.9));
    private static final double TREE_SPACING_METRES = 3;
    private static final double SQUARE_METRES_PER_TREE = 25;

    private static final double SPACING_METRES = 4;
    private static final double TREE_METRES = 3;
    private static final List<String> SKY_FACES = List.of("px", "nx", "py", "ny", "pz", "nz");

    private BenchLevels() {}

    /** Returns every benchmark level by its file name under {@code levels/bench/}. */
    public static Map<String, Level> all() {
        Map<String, Level> levels = new LinkedHashMap<>();
        levels.put("clear.json", clear());
        levels.put("skybox.json", skybox());
        levels.put("boxes-1000.json", boxes(1000));
        levels.put("boxes-10000.json", boxes(10000));
        levels.put("boxes-500-stack.json", BenchBodies.stack(sunlit()));
        levels.put("bodies-200.json", BenchBodies.shaft(sunlit()));
        levels.put("boxes-1000-portals.json", BenchPortals.facing(boxes(1000)));
        levels.put("billboards-400.json", billboards(400));
        levels.put("billboards-10000.json", billboards(10000));
        levels.put("portals-64.json", BenchPortals.hall(sunlit()));
        levels.put("terrain.json", terrain());
        levels.put("impostors-10000.json", forest(10_000));
        levels.put("impostors-100000.json", forest(100_000));
        return levels;
    }

    public static List<String> skyFiles() {
        return SKY_FACES.stream()
                .map(face -> "textures/bench/sky-" + face + ".png")
                .toList();
    }

    private static Level clear() {
        Environment environment = environment(null, CLEAR_COLOUR, null);
        return level("Bench: clear", "case A: nothing but the clear colour", environment, path(BenchPath::clear));
    }

    private static Level skybox() {
        Environment environment = environment(null, new Sky.Skybox(SkyboxLayout.FACES, skyFiles()), null);
        return level("Bench: skybox", "case B: six 512² faces, once round", environment, path(BenchPath::skybox));
    }

    /** Returns the lighting of the compared engines: texture · (0.3 + 0.8 max(0, n · l)). */
    private static Environment sunlit() {
        double irradiance = 0.8 * Math.PI;
        Sun sun = new Sun(new Vec3(0.5, 1, 0.3), new Vec3(irradiance, irradiance, irradiance), false);
        return environment(sun, CLEAR_COLOUR, new Vec3(0.3, 0.3, 0.3));
    }

    private static Level boxes(int count) {
        Level empty = level(
                "Bench: " + count + " boxes",
                "case C: unit boxes on a square grid of spacing 2, seen from a quarter in",
                sunlit(),
                path(frame -> BenchPath.boxes(count, frame)));
        Material box = new Material("box", ONE, "textures/bench/box.png", null, null, null, Vec3.ZERO, 1);
        return empty.with(List.of(box), grid(count));
    }

    private static Level terrain() {
        return BenchTerrain.on(level(
                "Bench: terrain",
                "case E: 1025 × 1025 heights 1 m apart, one texture, one sun",
                sunlit(),
                path(BenchPath::terrain)));
    }

    private static Level billboards(int count) {
        Level empty = level(
                "Bench: " + count + " billboards",
                "case D: blended trees on a jittered grid of spacing 4 over one textured ground",
                environment(null, CLEAR_COLOUR, ONE),
                path(frame -> BenchPath.above(count, 4, frame)));
        return planted(empty, count);
    }

    private static Level forest(int count) {
        Level empty = level(
                "Bench: forest of " + count,
                "case F: " + count + " trees as impostors, 25 m² each, seen from the same place over the middle",
                sunlit(),
                path(BenchPath::forest));
        return grown(empty, count);
    }

    private static List<Solid> grid(int count) {
        int side = BenchPath.side(count);
        double middle = (side - 1) / 2.0;
        List<Solid> solids = new ArrayList<>(count);
        for (int i = 0; i < count; i++) {
            Vec3 centre = new Vec3((i % side - middle) * 2, 0.5, (i / side - middle) * 2);
            solids.add(new Solid.Box("b" + i, "box", false, TextureMapping.FACE, centre, ONE, Map.of()));
        }
        return solids;
    }

    private static Environment environment(Sun sun, Sky sky, Vec3 ambient) {
        return new Environment(sun, sky, ambient, Exposure.NEUTRAL, ToneCurve.CLIP, null, List.of());
    }

    private static Level level(String name, String description, Environment environment, List<Camera.Waypoint> path) {
        Camera.Waypoint first = path.get(0);
        Camera camera = new Camera("main", first.position(), first.target(), UP, 0, 60, 0.5, 2000, path);
        return Level.of(name, description, environment, List.of(camera));
    }

    /** Returns one round of a camera path. */
    static List<Camera.Waypoint> path(IntFunction<Camera.Waypoint> track) {
        return IntStream.range(0, BenchPath.FRAMES).mapToObj(track).toList();
    }

    /**
     * Adds ground and trees as billboards.
     *
     * @param empty with light that leaves textures as they are
     */
    private static Level planted(Level empty, int count) {
        Billboards trees = Billboards.at(
                        "trees",
                        "textures/bench/tree.png",
                        Billboards.Facing.SPHERICAL,
                        TREE_METRES,
                        TREE_METRES,
                        places(count))
                .asBlended();
        return empty.with(List.of(ground()), List.of(plain(2000))).withBillboards(List.of(trees));
    }

    /** Returns the material of the plain. */
    private static Material ground() {
        return new Material("ground", ONE, "textures/bench/ground.png", null, null, null, Vec3.ZERO, 8);
    }

    /**
     * Returns level ground around the origin.
     *
     * @param side in metres
     */
    private static Solid plain(double side) {
        return new Solid.Box(
                "ground",
                "ground",
                false,
                TextureMapping.WORLD,
                new Vec3(0, -0.5, 0),
                new Vec3(side, 1, side),
                Map.of());
    }

    private static List<Vec3> places(int count) {
        int side = BenchPath.side(count);
        List<Vec3> places = new ArrayList<>(count);
        for (int i = 0; i < count; i++) {
            float x =
                    (i % side - (side - 1) / 2f + (BenchPixels.random(i, 0, 7) - 0.5f) * 0.7f) * (float) SPACING_METRES;
            float z =
                    (i / side - (side - 1) / 2f + (BenchPixels.random(i, 1, 7) - 0.5f) * 0.7f) * (float) SPACING_METRES;
            places.add(new Vec3(x, 0, z));
        }
        return places;
    }

    /** Adds ground and trees as models around the origin. */
    private static Level grown(Level empty, int count) {
        double side = Math.sqrt(SQUARE_METRES_PER_TREE * count);
        Material leaves = new Material("plants", ONE, "textures/plants.png", null, null, null, Vec3.ZERO, 1);
        List<ModelPlacement> trees = new ArrayList<>();
        trees.add(trees("oak", 1, 2 * count / 5));
        trees.add(trees("fir", 2, 2 * count / 5));
        trees.add(trees("birch", 3, count / 5));
        return empty.with(List.of(ground(), leaves), List.of(plain(side)), List.of(), trees);
    }

    private static ModelPlacement trees(String kind, int seed, int count) {
        return new ModelPlacement(kind, "models/plants/" + kind + ".3d", null, List.of(), "plants", false)
                .over(new Billboards.Field(null, seed, count, TREE_SPACING_METRES, null, 90, null), 0.35);
    }
}
