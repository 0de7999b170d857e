package nephele.engine.sim;

import java.util.ArrayList;
import java.util.List;
import nephele.engine.collision.SeamedWorld;
import nephele.engine.collision.rigid.Bodies;
import nephele.engine.collision.rigid.BodyState;
import nephele.engine.portal.CrossingWord;
import nephele.engine.portal.Portal;
import nephele.engine.portal.Portals;

/**
 * How a game goes on in a level that was edited under it. The edited level's fixed portals take the place of those
 * before; a shot's portal stays as long as its whole aperture still lies where a shot could put it, and closes
 * otherwise. Who stands in a portal that closes is treated as when a portal is moved.
 */
final class Continuation {
    private final SimLevel level;
    private final Spaces spaces;
    private final Occupants occupants;

    /** @param level the edited one */
    Continuation(SimLevel level, Spaces spaces) {
        this.level = level;
        this.spaces = spaces;
        occupants = new Occupants(level.bodies());
    }

    /** The state in the edited level; {@code null} when somebody who stands in a portal that closes finds no room. */
    SimState of(SimState state, SeamedWorld before) {
        Changeable around = state.around();
        if (around.bodies().size() != level.bodies().size()) {
            throw new IllegalArgumentException(
                    "the edited level has " + level.bodies().size() + " bodies, the game "
                            + around.bodies().size() + ": begin it anew");
        }
        List<Portal> all = fixed();
        Shots now = Shots.NONE;
        Shots.Colour earlier = around.shots().earlier();
        now = add(kept(earlier, around), earlier, now, all);
        now = add(kept(earlier.other(), around), earlier.other(), now, all);
        SeamedWorld after = spaces.of(new Portals(all, partners(all.size(), now)));
        SimState settled = occupants.settle(state.with(around.with(awake(around.bodies()))), before, after);
        return settled == null ? null : moved(settled, now, before.portals(), after.portals());
    }

    private List<Portal> fixed() {
        List<Portal> fixed = new ArrayList<>();
        for (int i = 0; i < level.portals().size(); i++) {
            fixed.add(level.portals().portal(i));
        }
        return fixed;
    }

    /** A shot's portal where it still holds, else {@code null}. */
    private Portal kept(Shots.Colour shot, Changeable around) {
        int index = around.shots().portal(shot);
        if (index == Shots.UNFIRED || level.gun() == null) {
            return null;
        }
        Portal portal = around.portals().portal(index);
        return level.gun().holds(portal, fixed()) ? portal : null;
    }

    private static Shots add(Portal portal, Shots.Colour shot, Shots shots, List<Portal> to) {
        if (portal == null) {
            return shots;
        }
        to.add(portal);
        return shots.with(shot, to.size() - 1);
    }

    private List<Integer> partners(int size, Shots shots) {
        List<Integer> partners = new ArrayList<>();
        for (int i = 0; i < size; i++) {
            partners.add(i < level.portals().size() ? level.portals().partner(i) : Portals.CLOSED);
        }
        if (shots.first() != Shots.UNFIRED && shots.second() != Shots.UNFIRED) {
            partners.set(shots.first(), shots.second());
            partners.set(shots.second(), shots.first());
        }
        return partners;
    }

    /** What carried them may be gone, and contacts speak of solids by number. */
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

    private static SimState moved(SimState settled, Shots shots, Portals before, Portals after) {
        Changeable around = settled.around();
        TickTrace trace = TickTrace.of(around.trace().pressed(), CrossingWord.EMPTY, List.of());
        Holding holding = held(around.holding(), before, after);
        Portals portals = after.size() == 0 ? Portals.NONE : after;
        return settled.with(new Changeable(around.bodies(), portals, shots, holding, trace));
    }

    /** The line to what is held by the portals' new numbers; let go of where one of them leads nowhere now. */
    private static Holding held(Holding holding, Portals before, Portals after) {
        CrossingWord word = CrossingWord.EMPTY;
        for (int i = 0; i < holding.word().length(); i++) {
            int now = indexOf(before.portal(holding.word().entry(i)).id(), after);
            if (now == Portals.CLOSED || !after.isOpen(now)) {
                return Holding.NOTHING;
            }
            word = word.then(now, after);
        }
        return new Holding(holding.body(), word, holding.ticksUnseen(), holding.leaving());
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
