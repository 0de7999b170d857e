package nephele.engine.rule;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Consumer;
import nephele.engine.collision.Collider;
import nephele.engine.collision.CollisionWorld;
import nephele.engine.collision.PortalWorld;
import nephele.engine.collision.RoundedHull;
import nephele.engine.collision.Separation;
import nephele.engine.collision.rigid.body.BodyTable;
import nephele.engine.level.Body;
import nephele.engine.level.Level;
import nephele.engine.level.Problem;
import nephele.engine.level.Problem.Topic;
import nephele.engine.level.placed.LevelRule;
import nephele.engine.level.placed.StaticShapes;
import nephele.engine.math.Aabb;
import nephele.engine.math.Vec3;
import nephele.engine.math.bvh.ItemList;
import nephele.engine.math.bvh.SpatialIndex;
import nephele.engine.portal.Portal;
import nephele.engine.portal.PortalTransform;
import nephele.engine.portal.Portals;
import nephele.engine.sim.state.PlayerDimensions;
import org.joml.Quaterniond;
import org.joml.Vector3d;
import org.joml.Vector3dc;

/**
 * Rules for bodies: their numbers agree, and they start free. An instance holds the bodies of a level at tick 0 and
 * measures how deep each overlaps its surroundings, through open portals too.
 */
final class BodyRules {
    static final LevelRule SHAPES = LevelRule.ofRecords((level, report) -> {
        LevelRule.each("bodies", level.bodies(), (path, body) -> {
            if (body instanceof Body.Capsule capsule && capsule.heightMetres() < 2 * capsule.radiusMetres()) {
                report.accept(Problem.error(
                        path + ".heightMetres",
                        "a capsule is at least as high as it is wide: make it " + 2 * capsule.radiusMetres()
                                + " or more, or a sphere"));
            }
        });
    });

    /** Depth of the space that is opened behind a portal. */
    private static final double MOST_REACH_METRES = 2.5;

    static final LevelRule REACH = LevelRule.ofRecords((level, report) -> {
        boolean hasPortals = level.portalGun() != null || !level.portals().isEmpty();
        LevelRule.each("bodies", level.bodies(), (path, body) -> {
            double reach = reachMetres(body);
            if (hasPortals && reach > MOST_REACH_METRES) {
                report.accept(Problem.warning(
                        path,
                        "reaches " + Math.round(reach * 100) / 100.0
                                + " m from its centre: in a portal, what is farther than " + MOST_REACH_METRES
                                + " m from the plane meets this side's solids"));
            }
        });
    });

    /** The greatest overlap that still counts as touching or rounding. */
    private static final double MOST_OVERLAP_METRES = 1e-3;

    /** The greatest number of bodies that are reported; a heap of bodies in one place has millions of pairs. */
    private static final int MOST_REPORTED = 50;

    /** Bodies overlap neither solids, opened at the fixed portals, nor the player nor each other. */
    static final LevelRule FREE = new LevelRule(LevelRule.Stage.WORLD, (level, assets, statics, report) -> {
        if (level.bodies().isEmpty()) {
            return;
        }
        BodyRules bodies = new BodyRules(level, statics);
        int reported = 0;
        for (int i = 0; i < level.bodies().size() && reported <= MOST_REPORTED; i++) {
            List<String> overlaps = bodies.overlaps(i);
            reported += overlaps.isEmpty() ? 0 : 1;
            if (reported <= MOST_REPORTED) {
                report(i, overlaps, report);
            } else {
                reportMore(report);
            }
        }
    });

    private static final Quaterniond UPRIGHT = new Quaterniond();
    private static final int NO_BODY = -1;

    private final Level level;
    private final BodyTable table;
    private final PortalWorld world;
    private final Portals portals;
    private final SpatialIndex index;
    private final List<Collider> colliders = new ArrayList<>();
    private final RoundedHull playerShape = PlayerDimensions.Stance.STANDING.shape();
    /** The centre of the player's capsule; {@code null} in a level without a player start. */
    private final Vec3 playerCentre;

    /** The portals that the player is active on at its start, one bit each. */
    private final long playerActive;

    private final Separation separation = new Separation();
    private final ItemList near = new ItemList();

    /**
     * The deepest overlap of a body.
     *
     * @param metres depth; 0 for none
     * @param name the solid's or model's id, {@code null} for others
     * @param body the other body's index, or −1
     */
    private record Overlap(double metres, String name, int body, boolean throughPortal) {
        static final Overlap NONE = new Overlap(0, null, NO_BODY, false);

        Overlap orDeeper(double depth, int other, boolean beyondPortal) {
            return depth > metres ? new Overlap(depth, null, other, beyondPortal) : this;
        }
    }

    private BodyRules(Level level, StaticShapes statics) {
        this.level = level;
        table = BodyTable.of(level);
        world = PortalWorld.of(CollisionWorld.of(statics), Portals.of(level));
        portals = world.portals();
        for (int i = 0; i < table.size(); i++) {
            colliders.add(table.collider(i, centre(i).toVector(), UPRIGHT));
        }
        index = SpatialIndex.of(colliders.stream().map(Collider::bounds).toList());
        playerCentre =
                level.player() == null ? null : playerCentre(level.player().feet());
        playerActive = playerCentre == null ? 0 : world.active(playerShape, playerCentre.toVector());
    }

    private static void report(int body, List<String> overlaps, Consumer<Problem> report) {
        overlaps.forEach(overlap -> report.accept(
                Problem.error("bodies[" + body + "].centre", overlap).about(Topic.ENTITY_IN_SOLID)));
    }

    private static void reportMore(Consumer<Problem> report) {
        report.accept(Problem.error("bodies", "there are more that overlap; these are the first " + MOST_REPORTED));
    }

    private List<String> overlaps(int body) {
        List<String> messages = new ArrayList<>();
        Overlap inSolid = deepestSolid(body);
        if (inSolid.metres() > MOST_OVERLAP_METRES) {
            messages.add(message(inSolid, "'" + inSolid.name() + "'", "move it out"));
        }
        Overlap inBody = deepestBody(body);
        if (inBody.metres() > MOST_OVERLAP_METRES) {
            Body other = level.bodies().get(inBody.body());
            messages.add(message(inBody, "bodies[" + inBody.body() + "] ('" + other.id() + "')", "move one of them"));
        }
        Overlap inPlayer = player(body);
        if (inPlayer.metres() > MOST_OVERLAP_METRES) {
            messages.add(message(inPlayer, "the player", "move it or player.feet"));
        }
        return messages;
    }

    private static String message(Overlap overlap, String what, String remedy) {
        return "the body starts " + millimetres(overlap.metres()) + " mm deep in " + what
                + (overlap.throughPortal() ? " through a portal" : "") + ": " + remedy;
    }

    private static String millimetres(double metres) {
        double millimetres = Math.rint(metres * 1e4) / 10;
        return millimetres == Math.rint(millimetres) ? Long.toString((long) millimetres) : Double.toString(millimetres);
    }

    private static Vec3 playerCentre(Vec3 feet) {
        return new Vec3(feet.x(), feet.y() + PlayerDimensions.Stance.STANDING.centreAboveFeet(), feet.z());
    }

    private Vec3 centre(int body) {
        return table.body(body).centre();
    }

    /** Returns the deepest overlap of a body with a solid. */
    Overlap deepestSolid(int body) {
        RoundedHull hull = table.uprightHull(body);
        Vector3d at = centre(body).toVector();
        CollisionWorld around = world.openedFor(world.active(hull, at));
        around.overlapping(colliders.get(body).bounds(), near);
        Overlap deepest = Overlap.NONE;
        for (int i = 0; i < near.size(); i++) {
            Collider solid = around.collider(near.get(i));
            double depth = depth(hull, at, solid);
            if (depth > deepest.metres()) {
                deepest = new Overlap(depth, solid.solidId(), NO_BODY, false);
            }
        }
        return deepest;
    }

    /** Returns the deepest overlap of a body with another one; each pair is reported for one of the two. */
    Overlap deepestBody(int body) {
        RoundedHull hull = table.uprightHull(body);
        Vector3d at = centre(body).toVector();
        listNear(colliders.get(body).bounds());
        Overlap deepest = Overlap.NONE;
        for (int i = 0; i < near.size(); i++) {
            if (near.get(i) < body) {
                deepest = deepest.orDeeper(depth(hull, at, colliders.get(near.get(i))), near.get(i), false);
            }
        }
        long active = world.active(hull, at);
        for (int entry = 0; active != 0 && entry < portals.size(); entry++) {
            if (isIn(active, entry)) {
                deepest = beyondPortal(deepest, body, entry);
            }
        }
        return deepest;
    }

    /** Measures a body that reaches into a portal against the bodies before the portal's exit. */
    private Overlap beyondPortal(Overlap before, int body, int entry) {
        PortalTransform transform = portals.transform(entry);
        Vector3d at = transform.point(centre(body).toVector());
        Quaterniond turn = transform.orientation(new Quaterniond());
        RoundedHull hull = table.hull(body, turn);
        listNear(table.collider(body, at, turn).bounds());
        Overlap deepest = before;
        for (int i = 0; i < near.size(); i++) {
            int other = near.get(i);
            if (other != body && meetsAt(portals.partner(entry), other, body)) {
                deepest = deepest.orDeeper(depth(hull, at, colliders.get(other)), other, true);
            }
        }
        return deepest;
    }

    /**
     * Returns true if a body is before an exit. Of two bodies that both reach into the portal, only one is compared
     * with the other.
     */
    private boolean meetsAt(int exit, int other, int comer) {
        RoundedHull hull = table.uprightHull(other);
        Vector3d at = centre(other).toVector();
        return isIn(world.active(hull, at), exit) ? other < comer : isBefore(portals.portal(exit), hull, at);
    }

    private static boolean isBefore(Portal portal, RoundedHull hull, Vector3dc at) {
        double least = portal.inFront(at.x(), at.y(), at.z()) + hull.support(-1, portal.normal());
        return least >= -MOST_OVERLAP_METRES;
    }

    /** Returns the overlap of a body with the player at its start. */
    Overlap player(int body) {
        if (playerCentre == null) {
            return Overlap.NONE;
        }
        Vector3d player = playerCentre.toVector();
        Vector3d at = centre(body).toVector();
        Overlap deepest = Overlap.NONE.orDeeper(depth(playerShape, player, colliders.get(body)), NO_BODY, false);
        long active = world.active(table.uprightHull(body), at);
        for (int entry = 0; (active | playerActive) != 0 && entry < portals.size(); entry++) {
            int exit = portals.partner(entry);
            if (portals.isOpen(entry) && (isIn(active, entry) || isIn(playerActive, exit))) {
                deepest = playerBeyond(deepest, body, entry);
            }
        }
        return deepest;
    }

    private Overlap playerBeyond(Overlap before, int body, int entry) {
        Vec3 at = centre(body);
        Portal from = portals.portal(entry);
        Portal to = portals.portal(portals.partner(entry));
        boolean meet = from.inFront(at.x(), at.y(), at.z()) >= 0
                && to.inFront(playerCentre.x(), playerCentre.y(), playerCentre.z()) >= 0;
        if (!meet) {
            return before;
        }
        PortalTransform transform = portals.transform(entry);
        Quaterniond turn = transform.orientation(new Quaterniond());
        Collider image = table.collider(body, transform.point(at.toVector()), turn);
        return before.orDeeper(depth(playerShape, playerCentre.toVector(), image), NO_BODY, true);
    }

    private static boolean isIn(long mask, int portal) {
        return portal < PortalWorld.MOST_PORTALS && (mask & 1L << portal) != 0;
    }

    private void listNear(Aabb bounds) {
        near.clear();
        index.overlapping(bounds, near);
        near.sort();
    }

    private double depth(RoundedHull shape, Vector3dc at, Collider in) {
        separation.measure(shape, at.x(), at.y(), at.z(), in);
        return Math.max(0, -separation.metres());
    }

    private static double reachMetres(Body body) {
        if (body instanceof Body.Box box) {
            return box.size().toVector().length() / 2;
        }
        if (body instanceof Body.Sphere sphere) {
            return sphere.radiusMetres();
        }
        return ((Body.Capsule) body).heightMetres() / 2;
    }
}
