package nephele.engine.walk;

import java.util.ArrayList;
import java.util.List;
import nephele.engine.portal.Portal;
import nephele.engine.portal.placement.Placed;
import nephele.engine.scene.Ghost;
import nephele.engine.sim.Shots;
import nephele.engine.sim.SimState;
import nephele.engine.sim.Simulation;
import nephele.engine.sim.TickEvent;

/**
 * The result that each shot would have in the last state: computed at most once a tick, and only if a frame shows it.
 */
final class Aiming {
    /** Distance below which two portals are at one place, so that one preview is enough. */
    private static final double SAME_PLACE_METRES = 0.05;

    private final Simulation simulation;
    private final Placed[] placed = new Placed[Shots.Colour.values().length];
    private SimState asked;
    private List<Ghost> ghosts = List.of();
    private Shots.Colour lastShot = Shots.Colour.SECOND;

    Aiming(Simulation simulation) {
        this.simulation = simulation;
    }

    /** Follows a tick that ended in this state. */
    void after(SimState state) {
        for (TickEvent event : state.around().trace().events()) {
            if (event instanceof TickEvent.PortalOpened opened) {
                lastShot = opened.shot();
            }
        }
    }

    /**
     * Returns the previews of the portals that shots would open; if both are at one place, that of the shot not fired
     * last.
     */
    List<Ghost> ghosts(SimState state) {
        ask(state);
        return ghosts;
    }

    /** Returns a half of the crosshair, {@code null} without a gun. */
    Sights.Half half(SimState state, Shots.Colour shot) {
        ask(state);
        Placed would = placed[shot.ordinal()];
        if (would == null) {
            return null;
        }
        boolean made = state.around().shots().portal(shot) != Shots.UNFIRED;
        boolean opens = would instanceof Placed.Fits;
        return new Sights.Half(
                made ? Sights.Portal.MADE : Sights.Portal.NONE, opens ? Sights.Shot.OPENS : Sights.Shot.REFUSED);
    }

    private void ask(SimState state) {
        if (asked == state) {
            return;
        }
        asked = state;
        for (Shots.Colour shot : Shots.Colour.values()) {
            placed[shot.ordinal()] = simulation.aim(state, shot);
        }
        ghosts = outlines(state);
    }

    private List<Ghost> outlines(SimState state) {
        List<Ghost> all = new ArrayList<>(2);
        for (Shots.Colour shot : Shots.Colour.values()) {
            Portal portal = placed[shot.ordinal()] instanceof Placed.Fits fits ? fits.portal() : null;
            if (portal != null && !isThereAlready(state, shot, portal)) {
                all.add(new Ghost(portal, shot.ordinal()));
            }
        }
        if (all.size() == 2 && areOnePlace(all.get(0).portal(), all.get(1).portal())) {
            all.remove(lastShot.ordinal());
        }
        return List.copyOf(all);
    }

    private static boolean isThereAlready(SimState state, Shots.Colour shot, Portal portal) {
        int own = state.around().shots().portal(shot);
        return own != Shots.UNFIRED
                && areOnePlace(portal, state.around().portals().portal(own));
    }

    private static boolean areOnePlace(Portal a, Portal b) {
        return a.centre().toVector().distance(b.centre().toVector()) < SAME_PLACE_METRES
                && a.normal().toVector().dot(b.normal().toVector()) > 0.99;
    }
}
