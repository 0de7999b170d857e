package nephele.engine.sim.carry;

import java.util.List;
import nephele.engine.collision.PortalWorld;
import nephele.engine.collision.rigid.body.BodyState;
import nephele.engine.math.Vec3;
import nephele.engine.portal.CrossingWord;
import nephele.engine.portal.Portals;
import nephele.engine.portal.placement.PlacementResult;
import nephele.engine.portal.placement.Refusal;
import nephele.engine.sim.state.GunPortals;
import nephele.engine.sim.state.PlayerInput;
import nephele.engine.sim.state.PlayerInput.Action;
import nephele.engine.sim.state.SimLevel;
import nephele.engine.sim.state.SimSettings;
import nephele.engine.sim.state.SimState;
import nephele.engine.sim.state.TickEvent;
import nephele.engine.sim.state.TickEvent.Handled;
import nephele.engine.sim.state.TickEvent.Handled.Kind;
import nephele.engine.sim.state.WorldState;
import nephele.engine.sim.state.WorldState.HeldBody;

/**
 * Executes the actions of gun and hands, at the start of a tick. An action counts only if it was not held in the tick
 * before. While a body is held, the first trigger throws it.
 */
public final class PlayerActions {
    static final double HEAVIEST_KILOGRAMS = 50;

    private final SimLevel level;
    private final PortalWorld.Cache worlds;
    private final PortalShots shots;
    private final CarryRules carry;
    private final PortalOccupants occupants;

    public PlayerActions(SimLevel level, PortalWorld.Cache worlds, SimSettings settings) {
        double secondsPerTick = 1.0 / settings.ticksPerSecond();
        this.level = level;
        this.worlds = worlds;
        var inWay = new BodyObstruction(level.bodies());
        shots = level.gun() == null ? null : new PortalShots(level.gun().with(settings.shotAids()), inWay);
        carry = new CarryRules(level.bodies(), inWay, secondsPerTick);
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
            events.add(new TickEvent.NothingInReach());
            return state;
        }
        boolean tooHeavy = level.bodies().massKilograms(grasp.body()) > HEAVIEST_KILOGRAMS;
        events.add(new Handled(tooHeavy ? Kind.TOO_HEAVY : Kind.PICKED_UP, grasp.body()));
        return tooHeavy ? state : state.with(state.world().with(grasp));
    }

    /** Returns what a shot would do now, for the portal preview; {@code null} without a gun. */
    public PlacementResult aim(SimState state, GunPortals.Colour shot) {
        return shots == null
                ? null
                : shots.aim(state, shot, worlds.of(state.world().portals()));
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
        if (shots == null) {
            return state;
        }
        PlacementResult placed = aim(state, shot);
        if (placed instanceof PlacementResult.Fits fits) {
            WorldState around = state.world();
            GunPortals now = PortalShots.shotsWith(shot, around);
            PortalWorld old = worlds.of(around.portals());
            PortalWorld next = worlds.of(PortalShots.portalsWith(fits.portal(), shot, now, around.portals()));
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
}
