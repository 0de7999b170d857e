package nephele.engine.sim;

import java.util.ArrayList;
import java.util.List;
import nephele.engine.collision.Collider;
import nephele.engine.collision.CollisionWorld;
import nephele.engine.collision.PortalWorld;
import nephele.engine.collision.RoundedHull;
import nephele.engine.collision.Separation;
import nephele.engine.collision.rigid.body.BodyTable;
import nephele.engine.level.Level;
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

/** The bodies of a level at tick 0; measures how deep each overlaps its surroundings, through open portals too. */
final class StartingBodies {
    private static final Vector3dc STILL = new Vector3d();
    private static final Quaterniond UPRIGHT = new Quaterniond();
    private static final int NO_BODY = -1;

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
    record Overlap(double metres, String name, int body, boolean throughPortal) {
        static final Overlap NONE = new Overlap(0, null, NO_BODY, false);

        Overlap orDeeper(double depth, int other, boolean beyondPortal) {
            return depth > metres ? new Overlap(depth, null, other, beyondPortal) : this;
        }
    }

    StartingBodies(Level level, StaticShapes statics) {
        table = BodyTable.of(level);
        world = PortalWorld.of(CollisionWorld.of(statics), Portals.of(level));
        portals = world.portals();
        for (int i = 0; i < table.size(); i++) {
            colliders.add(table.collider(i, centre(i).toVector(), UPRIGHT));
        }
        index = SpatialIndex.of(colliders.stream().map(Collider::bounds).toList());
        playerCentre =
                level.player() == null ? null : playerCentre(level.player().feet());
        playerActive = playerCentre == null ? 0 : world.active(playerShape, playerCentre.toVector(), STILL);
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
        CollisionWorld around = world.openedFor(world.active(hull, at, STILL));
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
        long active = world.active(hull, at, STILL);
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
        return isIn(world.active(hull, at, STILL), exit) ? other < comer : isBefore(portals.portal(exit), hull, at);
    }

    private static boolean isBefore(Portal portal, RoundedHull hull, Vector3dc at) {
        double least = portal.inFront(at.x(), at.y(), at.z()) + hull.support(-1, portal.normal());
        return least >= -StartRules.MOST_OVERLAP_METRES;
    }

    /** Returns the overlap of a body with the player at its start. */
    Overlap player(int body) {
        if (playerCentre == null) {
            return Overlap.NONE;
        }
        Vector3d player = playerCentre.toVector();
        Vector3d at = centre(body).toVector();
        Overlap deepest = Overlap.NONE.orDeeper(depth(playerShape, player, colliders.get(body)), NO_BODY, false);
        long active = world.active(table.uprightHull(body), at, STILL);
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
}
