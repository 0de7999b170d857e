package nephele.engine.sim.carry;

import java.util.ArrayList;
import java.util.List;
import nephele.engine.collision.PortalWorld;
import nephele.engine.math.Basis;
import nephele.engine.math.Vec3;
import nephele.engine.portal.Obstacles;
import nephele.engine.portal.PathTrace;
import nephele.engine.portal.Portal;
import nephele.engine.portal.PortalCrossing;
import nephele.engine.portal.Portals;
import nephele.engine.portal.placement.Placement;
import nephele.engine.portal.placement.PlacementResult;
import nephele.engine.portal.placement.Refusal;
import nephele.engine.portal.placement.ShotRay;
import nephele.engine.sim.state.GunPortals;
import nephele.engine.sim.state.PlayerState;
import nephele.engine.sim.state.SimState;
import nephele.engine.sim.state.WorldState;
import org.joml.Vector3d;

/**
 * Aims and applies the shots of the portal gun. A shot goes straight from the eye along the view to the first surface
 * and through no portal, as in the games of the genre, so a portal is always placed in sight of its own surroundings.
 * The two portals are linked as soon as both exist.
 */
final class PortalShots {
    private static final double FARTHEST_METRES = 1e5;
    /**
     * A portal this near the surface counts as part of it; the placement decides whether another one fits beside it.
     */
    private static final double IN_WALL_METRES = 0.01;

    private final Placement placement;
    private final BodyObstruction bodies;

    PortalShots(Placement placement, BodyObstruction bodies) {
        this.placement = placement;
        this.bodies = bodies;
    }

    /** Returns what a shot would do now. */
    PlacementResult aim(SimState state, GunPortals.Colour shot, PortalWorld space) {
        WorldState around = state.world();
        int own = around.shots().portal(shot);
        ShotRay aim = aim(state.player(), space.portals());
        Vec3 blocked = portalInTheWay(aim, own, space);
        if (blocked != null) {
            return new PlacementResult.Refused(Refusal.OVERLAPS_OTHER, blocked);
        }
        List<Portal> others = new ArrayList<>(around.portals().all());
        if (own != GunPortals.UNFIRED) {
            others.remove(own);
        }
        return placement.place(shot.portalId(), aim, others, bodies.at(around.bodies(), space.portals()));
    }

    /** Returns the aim from the eye's actual place, which may be beyond a portal that the body's centre is before. */
    private static ShotRay aim(PlayerState player, Portals portals) {
        Vector3d centre = player.centre(new Vector3d());
        Vector3d path = player.eye(new Vector3d()).sub(centre);
        var toEye = new PathTrace(portals, Obstacles.NONE);
        toEye.trace(centre, path);
        Basis view = player.view();
        return new ShotRay(
                Vec3.of(toEye.place()),
                new Basis(carried(toEye, view.right()), carried(toEye, view.up()), carried(toEye, view.back())));
    }

    private static Vec3 carried(PathTrace along, Vec3 direction) {
        return Vec3.of(along.carryDirection(direction.toVector()));
    }

    /** Returns where a shot hits another portal that stands free of any wall, {@code null} if it hits none. */
    private static Vec3 portalInTheWay(ShotRay aim, int own, PortalWorld space) {
        Vector3d eye = aim.eye().toVector();
        Vector3d path = aim.direction().toVector().mul(FARTHEST_METRES);
        path.mul(space.free(eye, path));
        Vector3d end = new Vector3d(eye).add(path);
        path.mul(Math.max(0, 1 - IN_WALL_METRES / path.length()));
        var crossing = new PortalCrossing();
        boolean meets = crossing.find(space.portals(), eye, path, new Vector3d(), 1);
        boolean isInTheWay = meets && crossing.portal() != own && !isOnGround(space, crossing.portal(), end);
        return isInTheWay ? Vec3.of(crossing.place()) : null;
    }

    /** Returns true if a portal lies on the ground that a shot hits; a flat shot crosses it far before the ground. */
    private static boolean isOnGround(PortalWorld space, int portal, Vector3d hit) {
        double step = space.groundStepMetres(portal);
        return step >= 0 && space.portals().portal(portal).inFront(hit.x, hit.y, hit.z) >= -step - IN_WALL_METRES;
    }

    /** Returns the shots after a shot; the first shot of a colour gets the next portal index. */
    static GunPortals shotsWith(GunPortals.Colour shot, WorldState around) {
        boolean isNew = around.shots().portal(shot) == GunPortals.UNFIRED;
        return isNew ? around.shots().with(shot, around.portals().size()) : around.shots();
    }

    /** Returns all portals after a shot: the fixed ones unchanged, the two of the gun linked. */
    static Portals portalsWith(Portal made, GunPortals.Colour shot, GunPortals shots, Portals before) {
        List<Portal> portals = new ArrayList<>(before.all());
        List<Integer> partners = new ArrayList<>(before.partners());
        int index = shots.portal(shot);
        if (index == portals.size()) {
            portals.add(made);
            partners.add(Portals.CLOSED);
        } else {
            portals.set(index, made);
        }
        int other = shots.portal(shot.other());
        if (other != GunPortals.UNFIRED) {
            partners.set(index, other);
            partners.set(other, index);
        }
        return new Portals(portals, partners);
    }
}
