package nephele.engine.sim.reach;

import static nephele.engine.sim.state.PlayerDimensions.GRAVITY_METRES_PER_SECOND_SQUARED;
import static nephele.engine.sim.state.PlayerDimensions.JUMP_METRES;
import static nephele.engine.sim.state.PlayerDimensions.RUN_METRES_PER_SECOND;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import nephele.engine.collision.CollisionWorld;
import nephele.engine.collision.RayCast;
import nephele.engine.level.Brush;
import nephele.engine.level.Level;
import nephele.engine.level.placed.StaticShape;
import nephele.engine.level.placed.StaticShapes;
import nephele.engine.math.Aabb;
import nephele.engine.math.ConvexPolyhedron;
import nephele.engine.math.Ray;
import nephele.engine.math.Vec3;
import nephele.engine.math.heightfield.HeightField;
import nephele.engine.portal.Aperture;
import nephele.engine.portal.Portals;
import nephele.engine.sim.Simulation;
import nephele.engine.sim.reach.EyeReach.Means;
import nephele.engine.sim.state.PlayerDimensions.Stance;

/**
 * Floods the free space around a level's solids from the player's eye. An eye passes between the centres of neighbouring
 * cells unless a face is between them, falls anywhere, and rises as high as its energy allows: a jump above the ground on
 * which it stands. A portal keeps the energy: the height that is left above one end is left above the other.
 */
final class ReachFlood {
    private static final double EYE_METRES = Stance.STANDING.eyeMetres();
    /** Solids farther from the player and all portals than this are walked over as if they were flat. */
    private static final double NEAR_METRES = 150;

    private static final double LEAST_GAIN_METRES = 0.05;
    private static final double CLEAR_METRES = 0.05;

    /** Places along a side of a terrain that takes portals. */
    private static final int GROUND_PLACES = 24;

    private final CollisionWorld world;
    private final Aabb domain;
    private final ReachGrid grid;
    private final RayCast cast = new RayCast();
    private final Ray ray = Ray.reusable();
    /** Height of an eye that stands on the ground below a cell; NaN before it is known. */
    private final double[] standing;
    /** A bit for each side of a cell whether it is known if an eye passes there, and whether it does. */
    private final byte[] asked;

    private final byte[] free;

    private Means means = Means.WALKING;
    /** The portals that an eye passes, and a point before each. */
    private Portals portals = Portals.NONE;

    private List<Vec3> mouths = List.of();

    private ReachFlood(StaticShapes statics, Aabb domain) {
        this.domain = domain;
        world = CollisionWorld.of(statics);
        grid = new ReachGrid(domain);
        standing = new double[grid.cells()];
        Arrays.fill(standing, Double.NaN);
        asked = new byte[grid.cells()];
        free = new byte[grid.cells()];
    }

    /** Returns the boxes that the player's eye reaches. */
    static List<EyeReach.Part> of(Level level, StaticShapes statics) {
        Vec3 eye = level.player().feet().plus(new Vec3(0, EYE_METRES, 0));
        Portals portals = Portals.of(level);
        Aabb solids = statics.bounds();
        Aabb domain = domain(level, solids, portals, eye);
        var flood = new ReachFlood(statics, domain);
        flood.start(eye);
        if (portals.size() > 0) {
            flood.open(portals);
        }
        if (level.portalGun() != null) {
            flood.shootTo(shots(statics));
        }
        List<EyeReach.Part> parts = flood.grid.parts();
        parts.addAll(flood.outside(solids.isEmpty() ? domain : solids.union(domain)));
        return parts;
    }

    private static Aabb domain(Level level, Aabb solids, Portals portals, Vec3 eye) {
        Aabb near = new Aabb(eye.x(), eye.y(), eye.z(), eye.x(), eye.y(), eye.z());
        for (int i = 0; i < portals.size(); i++) {
            near = near.union(Aabb.of(portals.portal(i).corners()));
        }
        Aabb wide = near.grown(NEAR_METRES);
        Aabb box = solids.isEmpty() ? near : near.union(cut(solids, wide));
        boolean canFly = portals.size() > 0 || level.portalGun() != null;
        double rise = EYE_METRES + JUMP_METRES + (canFly ? box.maxY() - box.minY() : 0);
        Aabb grown = box.grown(1);
        return new Aabb(
                grown.minX(),
                grown.minY(),
                grown.minZ(),
                grown.maxX(),
                Math.max(grown.maxY(), box.maxY() + rise),
                grown.maxZ());
    }

    private static Aabb cut(Aabb a, Aabb b) {
        return new Aabb(
                Math.max(a.minX(), b.minX()),
                Math.max(a.minY(), b.minY()),
                Math.max(a.minZ(), b.minZ()),
                Math.min(a.maxX(), b.maxX()),
                Math.min(a.maxY(), b.maxY()),
                Math.min(a.maxZ(), b.maxZ()));
    }

    /** Returns a place before each portalable face: a shot portal leads there from any other. */
    private static List<Vec3> shots(StaticShapes statics) {
        List<Vec3> places = new ArrayList<>();
        for (Brush solid : statics.solids()) {
            for (int i = 0; i < solid.faces().size(); i++) {
                if (solid.faces().get(i).portalable()) {
                    ConvexPolyhedron.Face face = solid.shape().faces().get(i);
                    places.add(middle(face.polygon()).plus(face.plane().normal().scaled(CLEAR_METRES)));
                }
            }
        }
        for (StaticShape.HeightGrid grid : statics.ground()) {
            if (grid.authored().portalable()) {
                addPlaces(grid.field(), places);
            }
        }
        return places;
    }

    /** Adds places over a terrain, as if it were flat everywhere. */
    private static void addPlaces(HeightField field, List<Vec3> places) {
        int columns = Math.min(field.cellColumns(), GROUND_PLACES);
        int rows = Math.min(field.cellRows(), GROUND_PLACES);
        for (int row = 0; row <= rows; row++) {
            for (int column = 0; column <= columns; column++) {
                int sampleColumn = column * field.cellColumns() / columns;
                int sampleRow = row * field.cellRows() / rows;
                double y = field.y(field.height(sampleColumn, sampleRow)) + CLEAR_METRES;
                places.add(new Vec3(field.x(sampleColumn), y, field.z(sampleRow)));
            }
        }
    }

    private static Vec3 middle(List<Vec3> polygon) {
        Vec3 sum = Vec3.ZERO;
        for (Vec3 corner : polygon) {
            sum = sum.plus(corner);
        }
        return sum.scaled(1.0 / polygon.size());
    }

    private void start(Vec3 eye) {
        enter(eye, eye.y() + JUMP_METRES);
        run();
    }

    /** Opens the portals and continues from every cell that is reached. */
    private void open(Portals through) {
        means = Means.PORTALS;
        portals = through;
        mouths = through.all().stream()
                .map(portal -> portal.world(0, 0, CLEAR_METRES))
                .toList();
        for (int cell = 0; cell < grid.cells(); cell++) {
            if (grid.isReached(cell)) {
                grid.enqueue(cell);
            }
        }
        run();
    }

    /** Continues from places to which shot portals lead, with all the energy that any cell has. */
    private void shootTo(List<Vec3> places) {
        means = Means.SHOTS;
        double head = greatestHead();
        for (Vec3 place : places) {
            enter(place, Math.max(head, place.y() + JUMP_METRES));
        }
        run();
    }

    private double greatestHead() {
        double greatest = Double.NEGATIVE_INFINITY;
        for (int cell = 0; cell < grid.cells(); cell++) {
            greatest = Math.max(greatest, grid.head(cell));
        }
        return greatest;
    }

    /** Reaches the cells around a point from which it is visible. */
    private void enter(Vec3 at, double head) {
        double half = grid.cellMetres() / 2;
        for (int corner = 0; corner < 8; corner++) {
            int cell = grid.cell(at.plus(new Vec3(
                    (corner & 1) == 0 ? -half : half,
                    (corner & 2) == 0 ? -half : half,
                    (corner & 4) == 0 ? -half : half)));
            if (cell >= 0 && isFree(at, grid.centre(cell))) {
                raise(cell, head);
            }
        }
    }

    private void raise(int cell, double head) {
        double most = Math.min(head, ceiling());
        boolean isHigher = !grid.isReached(cell) || most > grid.head(cell) + LEAST_GAIN_METRES;
        if (isHigher && grid.centre(cell).y() <= most + grid.cellMetres() / 2) {
            grid.reach(cell, most, means);
            grid.enqueue(cell);
        }
    }

    private double ceiling() {
        return grid.centre(grid.cells() - 1).y();
    }

    private void run() {
        for (int cell = grid.next(); cell >= 0; cell = grid.next()) {
            Vec3 at = grid.centre(cell);
            double head = Math.max(grid.head(cell), standing(cell, at) + JUMP_METRES);
            grid.reach(cell, head, means);
            for (int side = 0; side < 6; side++) {
                int next = grid.neighbour(cell, side);
                if (next >= 0 && mayRaise(next, head) && isFree(cell, side, at, next)) {
                    raise(next, head);
                }
            }
            for (int portal = 0; portal < portals.size(); portal++) {
                if (portals.isOpen(portal)) {
                    pass(portal, at, head);
                }
            }
        }
    }

    private boolean mayRaise(int cell, double head) {
        return !grid.isReached(cell) || head > grid.head(cell) + LEAST_GAIN_METRES;
    }

    /** Passes through a portal from the space before it to that before its partner, if it is near. */
    private void pass(int portal, Vec3 at, double head) {
        Aperture aperture = portals.portal(portal).aperture();
        double nearMetres = Math.max(aperture.widthMetres(), aperture.heightMetres()) / 2 + grid.cellMetres();
        Vec3 from = mouths.get(portal);
        if (at.minus(from).length() <= nearMetres && isFree(at, from)) {
            Vec3 to = mouths.get(portals.partner(portal));
            enter(to, head - from.y() + to.y());
        }
    }

    /** Returns the height of an eye that stands below a point; negative infinity without ground near. */
    private double standing(int cell, Vec3 at) {
        if (Double.isNaN(standing[cell])) {
            double reach = EYE_METRES + grid.cellMetres();
            ray.aim(at.x(), at.y(), at.z(), 0, -1, 0);
            standing[cell] =
                    cast.cast(world, ray, reach) ? at.y() - cast.distance() + EYE_METRES : Double.NEGATIVE_INFINITY;
        }
        return standing[cell];
    }

    /** Asks once for each side of a cell: a cell may be raised many times. */
    private boolean isFree(int cell, int side, Vec3 at, int next) {
        int bit = 1 << side;
        if ((asked[cell] & bit) == 0) {
            asked[cell] |= (byte) bit;
            free[cell] |= (byte) (isFree(at, grid.centre(next)) ? bit : 0);
        }
        return (free[cell] & bit) != 0;
    }

    private boolean isFree(Vec3 from, Vec3 to) {
        ray.aim(from.x(), from.y(), from.z(), to.x() - from.x(), to.y() - from.y(), to.z() - from.z());
        return !cast.cast(world, ray, 1);
    }

    /** Returns the air beside and below the domain if its edge is reached: all of it that a fall or a flight comes to. */
    private List<EyeReach.Part> outside(Aabb all) {
        List<EyeReach.Part> parts = new ArrayList<>();
        for (Means by : Means.values()) {
            double head = Double.NEGATIVE_INFINITY;
            for (int cell = 0; cell < grid.cells(); cell++) {
                if (grid.isReached(cell) && grid.means(cell) == by && grid.isAtEdge(cell)) {
                    head = Math.max(head, grid.head(cell));
                }
            }
            if (head != Double.NEGATIVE_INFINITY) {
                around(all, head, by, parts);
            }
        }
        return parts;
    }

    /** Adds the air beside the domain on each side, and below it. */
    private void around(Aabb all, double head, Means by, List<EyeReach.Part> parts) {
        double lowest = all.minY() - Simulation.FALL_METRES;
        double side = RUN_METRES_PER_SECOND * Math.sqrt(2 * (head - lowest) / GRAVITY_METRES_PER_SECOND_SQUARED)
                + (by == Means.WALKING ? 0 : 2 * (head - all.minY()));
        Aabb wide = new Aabb(all.minX() - side, lowest, all.minZ() - side, all.maxX() + side, head, all.maxZ() + side);
        Aabb in = domain;
        double low = lowest;
        parts.add(new EyeReach.Part(new Aabb(wide.minX(), low, wide.minZ(), in.minX(), head, wide.maxZ()), by));
        parts.add(new EyeReach.Part(new Aabb(in.maxX(), low, wide.minZ(), wide.maxX(), head, wide.maxZ()), by));
        parts.add(new EyeReach.Part(new Aabb(in.minX(), low, wide.minZ(), in.maxX(), head, in.minZ()), by));
        parts.add(new EyeReach.Part(new Aabb(in.minX(), low, in.maxZ(), in.maxX(), head, wide.maxZ()), by));
        parts.add(new EyeReach.Part(new Aabb(in.minX(), low, in.minZ(), in.maxX(), in.minY(), in.maxZ()), by));
    }
}
