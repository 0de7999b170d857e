package nephele.workshop.art.bench;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import nephele.engine.level.Camera;
import nephele.engine.level.Environment;
import nephele.engine.level.Level;
import nephele.engine.level.Material;
import nephele.engine.level.PortalShape;
import nephele.engine.level.PortalSpec;
import nephele.engine.level.Solid;
import nephele.engine.level.TextureMapping;
import nephele.engine.math.Vec3;

/** The benchmark scenes of portals: a single pair that repeats the boxes, and a hall of 64 portals. */
final class BenchPortals {
    /** The number of portals in the hall. */
    static final int MANY = 64;

    private static final Vec3 UP = new Vec3(0, 1, 0);
    /**
     * The quad of the compared engines has the aspect of their picture; it is 12 m ahead of the camera and 0.3 m above
     * its eye.
     */
    private static final double WIDTH_METRES = 8;

    private static final double HEIGHT_METRES = 4.5;
    private static final double AHEAD_METRES = 12;
    private static final double RAISED_METRES = 0.3;

    private static final int ROWS = 4;
    private static final int SIDE_COLUMNS = 5;
    private static final int BACK_COLUMNS = 6;
    private static final double ROW_METRES = 2.6;
    private static final double COLUMN_METRES = 2;
    private static final double HALL_METRES = 13;

    private BenchPortals() {}

    /**
     * Adds to a level of boxes two rectangles that face each other above the camera. Each view through one shows the
     * boxes and the rectangle again, so that the view budget limits the number of views.
     */
    static Level facing(Level boxes) {
        Camera main = boxes.cameras().get(0);
        Vec3 eye = main.position();
        double y = eye.y() + RAISED_METRES;
        double ahead = eye.z() - AHEAD_METRES;
        double exact = HEIGHT_METRES / 2 / StrictMath.tan(StrictMath.toRadians(main.verticalFovDegrees() / 2));
        Vec3 near = new Vec3(0, y, ahead + exact);
        Camera filled = new Camera("filled", near, new Vec3(0, y, ahead), UP, 0, 60, 0.5, 2000, List.of());
        return Level.of(
                        "Bench: 1 000 boxes and two portals",
                        "case G: the boxes through a pair of 8 x 4.5 m rectangles that face each other, 12 m ahead of"
                            + " the camera and 12 m behind it; the view budget says how many views are nested. Camera"
                            + " 'filled' sees nothing but the first",
                        boxes.environment(),
                        List.of(main, filled))
                .with(boxes.materials(), boxes.solids())
                .withPortals(List.of(
                        portal("ahead", "behind", new Vec3(0, y, ahead), new Vec3(0, 0, 1)),
                        portal("behind", "ahead", new Vec3(0, y, eye.z() + AHEAD_METRES), new Vec3(0, 0, -1))));
    }

    private static PortalSpec portal(String id, String to, Vec3 centre, Vec3 normal) {
        return new PortalSpec(id, to, centre, normal, UP, WIDTH_METRES, HEIGHT_METRES, PortalShape.RECTANGLE);
    }

    /** Returns a hall with four rows of arches on three walls. All arches are visible, and most show many others. */
    static Level hall(Environment environment) {
        Material box = new Material("box", new Vec3(1, 1, 1), "textures/bench/box.png", null, null, null, Vec3.ZERO, 1);
        return Level.of(
                        "Bench: 64 portals",
                        "a hall with four rows of arches on three walls, all in sight; each leads to another wall and"
                                + " sees more arches",
                        environment,
                        List.of(new Camera(
                                "main",
                                hallPoint(0).position(),
                                hallPoint(0).target(),
                                UP,
                                0,
                                60,
                                0.1,
                                500,
                                BenchLevels.path(BenchPortals::hallPoint))))
                .with(List.of(box), hallSolids())
                .withPortals(hallPortals());
    }

    /** Returns a camera that moves a little from side to side, with every arch in the picture. */
    private static Camera.Waypoint hallPoint(int frame) {
        double phase = 2 * StrictMath.PI * frame / BenchPath.FRAMES;
        Vec3 eye = new Vec3(0.8 * StrictMath.sin(phase), ROWS * ROW_METRES / 2, 14);
        return new Camera.Waypoint(eye, new Vec3(0, eye.y(), 0));
    }

    private static List<Solid> hallSolids() {
        double half = HALL_METRES / 2;
        double height = ROWS * ROW_METRES;
        List<Solid> solids = new ArrayList<>(List.of(
                box("floor", new Vec3(0, -0.5, 0), new Vec3(HALL_METRES, 1, HALL_METRES)),
                box("west", new Vec3(-half - 0.5, height / 2, 0), new Vec3(1, height, HALL_METRES)),
                box("east", new Vec3(half + 0.5, height / 2, 0), new Vec3(1, height, HALL_METRES)),
                box("back", new Vec3(0, height / 2, -half - 0.5), new Vec3(HALL_METRES, height, 1))));
        for (int i = 0; i < 36; i++) {
            Vec3 centre = new Vec3(2 * (i % 6) - 5, 0.5, 2 * (i / 6) - 5);
            solids.add(box("b" + i, centre, new Vec3(1, 1, 1)));
        }
        return solids;
    }

    private static Solid box(String id, Vec3 centre, Vec3 size) {
        TextureMapping mapping = id.startsWith("b") ? TextureMapping.FACE : TextureMapping.WORLD;
        return new Solid.Box(id, "box", false, mapping, centre, size, Map.of());
    }

    /**
     * Links each arch of the left wall to the right wall one row higher, and the left half of the back wall to its
     * right half.
     */
    private static List<PortalSpec> hallPortals() {
        List<PortalSpec> portals = new ArrayList<>(MANY);
        double wall = HALL_METRES / 2;
        for (int row = 0; row < ROWS; row++) {
            int partnerRow = (row + 1) % ROWS;
            for (int column = 0; column < SIDE_COLUMNS; column++) {
                double along = offset(column, SIDE_COLUMNS);
                Vec3 west = new Vec3(-wall, height(row), along);
                Vec3 east = new Vec3(wall, height(partnerRow), -along);
                String id = "side-" + row + "-" + column;
                portals.add(spec(id + "-a", id + "-b", west, new Vec3(1, 0, 0)));
                portals.add(spec(id + "-b", id + "-a", east, new Vec3(-1, 0, 0)));
            }
            for (int column = 0; column < BACK_COLUMNS / 2; column++) {
                Vec3 left = new Vec3(offset(column, BACK_COLUMNS), height(row), -wall);
                Vec3 right = new Vec3(offset(BACK_COLUMNS - 1 - column, BACK_COLUMNS), height(partnerRow), -wall);
                String id = "back-" + row + "-" + column;
                portals.add(spec(id + "-a", id + "-b", left, new Vec3(0, 0, 1)));
                portals.add(spec(id + "-b", id + "-a", right, new Vec3(0, 0, 1)));
            }
        }
        return portals;
    }

    private static PortalSpec spec(String id, String to, Vec3 centre, Vec3 normal) {
        return new PortalSpec(id, to, centre, normal, UP, 1.2, 2.1, PortalShape.ARCH);
    }

    private static double height(int row) {
        return 1.3 + ROW_METRES * row;
    }

    private static double offset(int column, int columns) {
        return (column - (columns - 1) / 2.0) * COLUMN_METRES;
    }
}
