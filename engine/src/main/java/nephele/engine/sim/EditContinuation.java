package nephele.engine.sim;

import java.util.ArrayList;
import java.util.List;
import nephele.engine.collision.PortalWorld;
import nephele.engine.collision.rigid.body.Bodies;
import nephele.engine.collision.rigid.body.BodyState;
import nephele.engine.portal.CrossingWord;
import nephele.engine.portal.Portal;
import nephele.engine.portal.Portals;
import nephele.engine.sim.carry.PortalOccupants;
import nephele.engine.sim.state.GunPortals;
import nephele.engine.sim.state.SimLevel;
import nephele.engine.sim.state.SimState;
import nephele.engine.sim.state.WorldState;
import nephele.engine.sim.state.WorldState.ExitState;
import nephele.engine.sim.state.WorldState.HeldBody;
import nephele.engine.sim.state.WorldState.TickTrace;

/**
 * Continues a running game in an edited level. The fixed portals of the edited level replace the earlier ones. A shot
 * portal stays if its whole aperture is still where a shot could place it, and closes otherwise. Bodies and players in
 * a portal that closes are treated as when a portal is moved. Exits can be entered again.
 */
final class EditContinuation {
    private final SimLevel level;
    private final PortalWorld.Cache worlds;
    private final PortalOccupants occupants;

    /** @param level the edited level */
    EditContinuation(SimLevel level, PortalWorld.Cache worlds) {
        this.level = level;
        this.worlds = worlds;
        occupants = new PortalOccupants(level.bodies());
    }

    /**
     * Returns the state in the edited level; {@code null} if the player or a body in a closing portal finds no room.
     *
     * @throws IllegalArgumentException if the edited level has a different number of bodies
     */
    SimState of(SimState state, PortalWorld before) {
        WorldState around = state.world();
        if (around.bodies().size() != level.bodies().size()) {
            throw new IllegalArgumentException(
                    "the edited level has " + level.bodies().size() + " bodies, the game "
                            + around.bodies().size() + ": begin it anew");
        }
        List<Portal> all = new ArrayList<>(level.portals().all());
        GunPortals now = GunPortals.NONE;
        GunPortals.Colour earlier = around.shots().earlier();
        now = add(kept(earlier, around), earlier, now, all);
        now = add(kept(earlier.other(), around), earlier.other(), now, all);
        PortalWorld after = worlds.of(new Portals(all, partners(all.size(), now)));
        SimState settled = occupants.settle(state.with(around.with(awake(around.bodies()))), before, after);
        return settled == null ? null : moved(settled, now, before.portals(), after.portals());
    }

    /** Returns a shot's portal if it is still valid, else {@code null}. */
    private Portal kept(GunPortals.Colour shot, WorldState around) {
        int index = around.shots().portal(shot);
        if (index == GunPortals.UNFIRED || level.gun() == null) {
            return null;
        }
        Portal portal = around.portals().portal(index);
        return level.gun().holds(portal, level.portals().all()) ? portal : null;
    }

    private static GunPortals add(Portal portal, GunPortals.Colour shot, GunPortals shots, List<Portal> to) {
        if (portal == null) {
            return shots;
        }
        to.add(portal);
        return shots.with(shot, to.size() - 1);
    }

    private List<Integer> partners(int size, GunPortals shots) {
        List<Integer> partners = new ArrayList<>(level.portals().partners());
        while (partners.size() < size) {
            partners.add(Portals.CLOSED);
        }
        if (shots.first() != GunPortals.UNFIRED && shots.second() != GunPortals.UNFIRED) {
            partners.set(shots.first(), shots.second());
            partners.set(shots.second(), shots.first());
        }
        return partners;
    }

    /**
     * Returns the bodies awake and without contacts: their support may be gone, and contacts refer to solids by index.
     */
    private static Bodies awake(Bodies bodies) {
        if (bodies.size() == 0) {
            return bodies;
        }
        List<BodyState> states = new ArrayList<>();
        for (int i = 0; i < bodies.size(); i++) {
            states.add(bodies.state(i));
        }
        return Bodies.of(states);
    }

    private SimState moved(SimState settled, GunPortals shots, Portals before, Portals after) {
        WorldState around = settled.world();
        TickTrace trace = TickTrace.of(around.trace().pressed(), CrossingWord.EMPTY, List.of());
        HeldBody holding = held(around.holding(), before, after);
        Portals portals = after.size() == 0 ? Portals.NONE : after;
        ExitState exit = ExitState.start(level.exits());
        return settled.with(new WorldState(
                around.bodies(),
                portals,
                shots,
                holding,
                trace,
                exit,
                around.fall(),
                around.arrival().over()));
    }

    /**
     * Returns the holding with the new portal indices, or {@link HeldBody#NOTHING} if one of its portals is now gone or
     * closed.
     */
    private static HeldBody held(HeldBody holding, Portals before, Portals after) {
        CrossingWord word = CrossingWord.EMPTY;
        for (int i = 0; i < holding.word().length(); i++) {
            int now = indexOf(before.portal(holding.word().entry(i)).id(), after);
            if (now == Portals.CLOSED || !after.isOpen(now)) {
                return HeldBody.NOTHING;
            }
            word = word.then(now, after);
        }
        return new HeldBody(holding.body(), word, holding.ticksUnseen(), holding.leaving());
    }

    private static int indexOf(String id, Portals portals) {
        for (int i = 0; i < portals.size(); i++) {
            if (portals.portal(i).id().equals(id)) {
                return i;
            }
        }
        return Portals.CLOSED;
    }
}
