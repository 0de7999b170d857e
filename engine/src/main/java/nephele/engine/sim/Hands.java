package nephele.engine.sim;

import java.util.List;
import nephele.engine.collision.SeamedWorld;
import nephele.engine.collision.rigid.BodyState;
import nephele.engine.math.Vec3;
import nephele.engine.portal.CrossingWord;
import nephele.engine.portal.Portals;
import nephele.engine.portal.placement.Placed;
import nephele.engine.portal.placement.Refusal;
import nephele.engine.sim.TickEvent.Handled;
import nephele.engine.sim.TickEvent.Handled.Kind;

/**
 * Executes the actions of gun and hands, at the start of a tick. An action counts only if it was not held in the tick
 * before. While a body is held, the first trigger throws it.
 */
final class Hands {
    static final double HEAVIEST_KILOGRAMS = 50;

    private final SimLevel level;
    private final Spaces spaces;
    private final PortalShots shots;
    private final Carry carry;
    private final HeldDrive drive;
    private final Occupants occupants;

    Hands(SimLevel level, Spaces spaces, double secondsPerTick) {
        this.level = level;
        this.spaces = spaces;
        var inWay = new BodiesInWay(level.bodies());
        shots = level.gun() == null ? null : new PortalShots(level.gun(), inWay);
        carry = new Carry(level.bodies(), inWay, secondsPerTick);
        drive = new HeldDrive(level.bodies(), secondsPerTick);
        occupants = new Occupants(level.bodies());
    }

    /** Returns the state after the actions, in which everything then moves: with other portals or another holding. */
    SimState act(SimState before, PlayerInput input, List<TickEvent> events) {
        int fresh = input.actions() & ~before.around().trace().pressed();
        SimState state = before;
        if (state.around().holding().isHolding()) {
            state = letGo(state, fresh, events);
        } else {
            state = is(Action.CARRY, fresh) && level.bodies().size() > 0 ? pickUp(state, events) : state;
            state = is(Action.FIRE_FIRST, fresh) ? fire(state, Shots.Colour.FIRST, events) : state;
        }
        return is(Action.FIRE_SECOND, fresh) ? fire(state, Shots.Colour.SECOND, events) : state;
    }

    private static boolean is(Action action, int pressed) {
        return (pressed & action.bit()) != 0;
    }

    private SimState letGo(SimState state, int fresh, List<TickEvent> events) {
        Holding held = state.around().holding();
        Portals portals = state.around().portals();
        if ((is(Action.THROW, fresh) || is(Action.FIRE_FIRST, fresh)) && held.isOpen(portals)) {
            BodyState thrown = drive.thrown(state, portals);
            events.add(new Handled(Kind.THROWN, held.body()));
            Changeable around = state.around().with(held.released());
            return state.with(around.with(around.bodies().with(held.body(), thrown)));
        }
        if (is(Action.CARRY, fresh)) {
            events.add(new Handled(Kind.DROPPED, held.body()));
            return state.with(state.around().with(held.released()));
        }
        return state;
    }

    private SimState pickUp(SimState state, List<TickEvent> events) {
        Holding grasp = carry.reach(state, spaces.of(state.around().portals()));
        if (!grasp.isHolding()) {
            events.add(new TickEvent.NothingInReach());
            return state;
        }
        boolean tooHeavy = level.bodies().massKilograms(grasp.body()) > HEAVIEST_KILOGRAMS;
        events.add(new Handled(tooHeavy ? Kind.TOO_HEAVY : Kind.PICKED_UP, grasp.body()));
        return tooHeavy ? state : state.with(state.around().with(grasp));
    }

    /** Returns what a shot would do now, for the portal preview; {@code null} without a gun. */
    Placed aim(SimState state, Shots.Colour shot) {
        return shots == null
                ? null
                : shots.aim(state, shot, spaces.of(state.around().portals()));
    }

    private SimState fire(SimState state, Shots.Colour shot, List<TickEvent> events) {
        if (shots == null) {
            return state;
        }
        Placed placed = aim(state, shot);
        if (placed instanceof Placed.Fits fits) {
            Changeable around = state.around();
            Shots now = PortalShots.shotsWith(shot, around);
            SeamedWorld old = spaces.of(around.portals());
            SeamedWorld next = spaces.of(PortalShots.portalsWith(fits.portal(), shot, now, around.portals()));
            SimState settled = occupants.settle(state, old, next);
            if (settled != null) {
                events.add(new TickEvent.PortalOpened(shot, now.portal(shot)));
                return settled.with(settled.around().with(next.portals(), now));
            }
            Vec3 where = fits.portal().centre();
            events.add(new TickEvent.PortalRefused(shot, Refusal.OCCUPIED, where));
        } else if (placed instanceof Placed.Refused refused) {
            events.add(new TickEvent.PortalRefused(shot, refused.reason(), refused.where()));
        }
        return state;
    }

    /**
     * Returns the motion of the held body in this tick; {@code null} if nothing is held or a portal on the line to it
     * is closed.
     */
    BodyState drive(SimState state, PlayerInput input) {
        Portals portals = state.around().portals();
        Holding held = state.around().holding();
        return held.isHolding() && held.isOpen(portals) ? drive.motion(state, input, spaces.of(portals)) : null;
    }

    /** Updates the line to the held body after everything has moved, or drops the body. */
    SimState follow(SimState moved, CrossingWord playerCrossed, List<TickEvent> events) {
        Changeable around = moved.around();
        Holding held = around.holding();
        if (!held.isHolding()) {
            return held.leaving() == Holding.NONE || carry.isWithin(moved.player(), around.bodies(), held.leaving())
                    ? moved
                    : moved.with(around.with(Holding.NOTHING));
        }
        SeamedWorld space = spaces.of(around.portals());
        Holding along = Carry.follow(held, playerCrossed, around.bodies(), space.portals());
        Holding kept = carry.keepInSight(along, moved.player(), around.bodies(), space);
        if (!kept.isHolding()) {
            events.add(new Handled(Kind.LOST, held.body()));
        }
        return moved.with(around.with(kept));
    }
}
