package nephele.engine.sim.carry;

import java.util.ArrayList;
import java.util.List;
import nephele.engine.collision.PortalWorld;
import nephele.engine.collision.rigid.body.BodyState;
import nephele.engine.math.Basis;
import nephele.engine.math.Vec3;
import nephele.engine.portal.CrossingWord;
import nephele.engine.portal.PathTrace;
import nephele.engine.portal.Portal;
import nephele.engine.portal.PortalCrossing;
import nephele.engine.portal.Portals;
import nephele.engine.portal.placement.Placement;
import nephele.engine.portal.placement.PlacementResult;
import nephele.engine.portal.placement.PlacementResult.Refusal;
import nephele.engine.portal.placement.ShotRay;
import nephele.engine.sim.state.GunPortals;
import nephele.engine.sim.state.PlayerInput;
import nephele.engine.sim.state.PlayerInput.Action;
import nephele.engine.sim.state.PlayerState;
import nephele.engine.sim.state.SimLevel;
import nephele.engine.sim.state.SimSettings;
import nephele.engine.sim.state.SimState;
import nephele.engine.sim.state.TickEvent;
import nephele.engine.sim.state.TickEvent.Handled;
import nephele.engine.sim.state.TickEvent.Handled.Kind;
import nephele.engine.sim.state.WorldState;
import nephele.engine.sim.state.WorldState.HeldBody;
import org.joml.Vector3d;

/**
 * Executes the actions of gun and hands, at the start of a tick. An action counts only if it was not held in the tick
 * before. While a body is held, the first trigger throws it.
 *
 * <p>A shot goes straight from the eye along the view to the first surface and through no portal, as in the games of the
 * genre, so a portal is always placed in sight of its own surroundings. The gun's two portals are linked as soon as both
 * exist.
 */
public final class PlayerActions {
    static final double HEAVIEST_KILOGRAMS = 50;
    private static final double FARTHEST_METRES = 1e5;
    /**
     * A portal this near the surface counts as part of it; the placement decides whether another one fits beside it.
     */
    private static final double IN_WALL_METRES = 0.01;

    private final SimLevel level;
    private final PortalWorld.Cache worlds;
    /** {@code null} without a gun. */
    private final Placement placement;

    private final BodyObstruction obstruction;
    private final CarryRules carry;
    private final PortalOccupants occupants;

    public PlayerActions(SimLevel level, PortalWorld.Cache worlds, SimSettings settings) {
        double secondsPerTick = 1.0 / settings.ticksPerSecond();
        this.level = level;
        this.worlds = worlds;
        obstruction = new BodyObstruction(level.bodies());
        placement = level.gun() == null ? null : level.gun().with(settings.shotAids());
        carry = new CarryRules(level.bodies(), obstruction, secondsPerTick);
        occupants = new PortalOccupants(level.bodies());
    }

    /** Returns the state after the actions, in which everything then moves: with other portals or another holding. */
    public SimState act(SimState before, PlayerInput input, List<TickEvent> events) {
        int fresh = input.actions() & ~before.world().trace().pressed();
        SimState state = before;
        if (state.world().holding().isHolding()) {
            state = letGo(state, fresh, events);
        } else {
            state = is(Action.CARRY, fresh) && level.bodies().size() > 0 ? pickUp(state, events) : state;
            state = is(Action.FIRE_FIRST, fresh) ? fire(state, GunPortals.Colour.FIRST, events) : state;
        }
        return is(Action.FIRE_SECOND, fresh) ? fire(state, GunPortals.Colour.SECOND, events) : state;
    }

    private static boolean is(Action action, int pressed) {
        return (pressed & action.bit()) != 0;
    }

    private SimState letGo(SimState state, int fresh, List<TickEvent> events) {
        HeldBody held = state.world().holding();
        Portals portals = state.world().portals();
        if ((is(Action.THROW, fresh) || is(Action.FIRE_FIRST, fresh)) && held.isOpen(portals)) {
            BodyState thrown = carry.thrown(state, portals);
            events.add(new Handled(Kind.THROWN, held.body()));
            WorldState around = state.world().with(held.released());
            return state.with(around.with(around.bodies().with(held.body(), thrown)));
        }
        if (is(Action.CARRY, fresh)) {
            events.add(new Handled(Kind.DROPPED, held.body()));
            return state.with(state.world().with(held.released()));
        }
        return state;
    }

    private SimState pickUp(SimState state, List<TickEvent> events) {
        HeldBody grasp = carry.reach(state, worlds.of(state.world().portals()));
        if (!grasp.isHolding()) {
            events.add(TickEvent.Plain.NOTHING_IN_REACH);
            return state;
        }
        boolean tooHeavy = level.bodies().massKilograms(grasp.body()) > HEAVIEST_KILOGRAMS;
        events.add(new Handled(tooHeavy ? Kind.TOO_HEAVY : Kind.PICKED_UP, grasp.body()));
        return tooHeavy ? state : state.with(state.world().with(grasp));
    }

    /** Returns what a shot would do now, for the portal preview; {@code null} without a gun. */
    public PlacementResult aim(SimState state, GunPortals.Colour shot) {
        if (placement == null) {
            return null;
        }
        WorldState around = state.world();
        PortalWorld space = worlds.of(around.portals());
        int own = around.shots().portal(shot);
        ShotRay ray = ray(state.player(), space.portals());
        Vec3 blocked = blockingPortal(ray, own, space);
        if (blocked != null) {
            return new PlacementResult.Refused(Refusal.OVERLAPS_OTHER, blocked);
        }
        List<Portal> others = new ArrayList<>(around.portals().all());
        if (own != GunPortals.UNFIRED) {
            others.remove(own);
        }
        return placement.place(shot.portalId(), ray, others, obstruction.at(around.bodies(), space.portals()));
    }

    /** Returns true if the player holds nothing and would pick up a body now. */
    public boolean canPickUp(SimState state) {
        if (level.bodies().size() == 0 || state.world().holding().isHolding()) {
            return false;
        }
        HeldBody grasp = carry.reach(state, worlds.of(state.world().portals()));
        return grasp.isHolding() && level.bodies().massKilograms(grasp.body()) <= HEAVIEST_KILOGRAMS;
    }

    private SimState fire(SimState state, GunPortals.Colour shot, List<TickEvent> events) {
        PlacementResult placed = aim(state, shot);
        if (placed instanceof PlacementResult.Fits fits) {
            WorldState around = state.world();
            GunPortals now = shotsWith(shot, around);
            PortalWorld old = worlds.of(around.portals());
            PortalWorld next = worlds.of(portalsWith(fits.portal(), shot, now, around.portals()));
            SimState settled = occupants.settle(state, old, next);
            if (settled != null) {
                events.add(new TickEvent.PortalOpened(shot, now.portal(shot)));
                return settled.with(settled.world().with(next.portals(), now));
            }
            Vec3 where = fits.portal().centre();
            events.add(new TickEvent.PortalRefused(shot, Refusal.OCCUPIED, where));
        } else if (placed instanceof PlacementResult.Refused refused) {
            events.add(new TickEvent.PortalRefused(shot, refused.reason(), refused.where(), refused.unevenMetres()));
        }
        return state;
    }

    /**
     * Returns the motion of the held body in this tick; {@code null} if nothing is held or a portal on the line to it
     * is closed.
     */
    public BodyState drive(SimState state, PlayerInput input) {
        Portals portals = state.world().portals();
        HeldBody held = state.world().holding();
        return held.isHolding() && held.isOpen(portals) ? carry.motion(state, input, worlds.of(portals)) : null;
    }

    /** Updates the line to the held body after everything has moved, or drops the body. */
    public SimState follow(SimState moved, CrossingWord playerCrossed, List<TickEvent> events) {
        WorldState around = moved.world();
        HeldBody held = around.holding();
        if (!held.isHolding()) {
            return held.leaving() == HeldBody.NONE || carry.isWithin(moved.player(), around.bodies(), held.leaving())
                    ? moved
                    : moved.with(around.with(HeldBody.NOTHING));
        }
        PortalWorld space = worlds.of(around.portals());
        HeldBody along = CarryRules.follow(held, playerCrossed, around.bodies(), space.portals());
        HeldBody kept = carry.keepInSight(along, moved.player(), around.bodies(), space);
        if (!kept.isHolding()) {
            events.add(new Handled(Kind.LOST, held.body()));
        }
        return moved.with(around.with(kept));
    }

    /** Returns the aim from the eye's actual place, which may be beyond a portal that the body's centre is before. */
    private static ShotRay ray(PlayerState player, Portals portals) {
        PathTrace toEye = player.pathToEye(portals);
        Basis view = player.view();
        return new ShotRay(
                Vec3.of(toEye.place()),
                new Basis(carried(toEye, view.right()), carried(toEye, view.up()), carried(toEye, view.back())));
    }

    private static Vec3 carried(PathTrace along, Vec3 direction) {
        return Vec3.of(along.carryDirection(direction.toVector()));
    }

    /** Returns where a shot hits another portal that stands free of any wall, {@code null} if it hits none. */
    private static Vec3 blockingPortal(ShotRay aim, int own, PortalWorld space) {
        Vector3d eye = aim.eye().toVector();
        Vector3d path = aim.direction().toVector().mul(FARTHEST_METRES);
        path.mul(space.free(eye, path));
        Vector3d end = new Vector3d(eye).add(path);
        path.mul(Math.max(0, 1 - IN_WALL_METRES / path.length()));
        var crossing = new PortalCrossing();
        boolean meets = crossing.find(space.portals(), eye, path, new Vector3d(), 1);
        boolean isBlocking = meets && crossing.portal() != own && !isOnGround(space, crossing.portal(), end);
        return isBlocking ? Vec3.of(crossing.place()) : null;
    }

    /** Returns true if a portal lies on the ground that a shot hits; a flat shot crosses it far before the ground. */
    private static boolean isOnGround(PortalWorld space, int portal, Vector3d hit) {
        double step = space.groundStepMetres(portal);
        return step >= 0 && space.portals().portal(portal).inFront(hit.x, hit.y, hit.z) >= -step - IN_WALL_METRES;
    }

    /** Returns the shots after a shot; the first shot of a colour gets the next portal index. */
    private static GunPortals shotsWith(GunPortals.Colour shot, WorldState around) {
        boolean isNew = around.shots().portal(shot) == GunPortals.UNFIRED;
        return isNew ? around.shots().with(shot, around.portals().size()) : around.shots();
    }

    /** Returns all portals after a shot: the fixed ones unchanged, the two of the gun linked. */
    private static Portals portalsWith(Portal made, GunPortals.Colour shot, GunPortals shots, Portals before) {
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
