package nephele.engine.playthrough;

import java.util.ArrayList;
import java.util.List;
import nephele.engine.portal.Portal;
import nephele.engine.portal.placement.PlacementResult;
import nephele.engine.scene.PortalPreview;
import nephele.engine.sim.Simulation;
import nephele.engine.sim.state.GunPortals;
import nephele.engine.sim.state.SimState;
import nephele.engine.sim.state.TickEvent;

/**
 * The result that each shot would have in the last state: computed at most once a tick, and only if a frame shows it.
 */
final class ShotPreviews {
    /** Distance below which two portals are at one place, so that one preview is enough. */
    private static final double SAME_PLACE_METRES = 0.05;

    private final Simulation simulation;
    private final PlacementResult[] placed = new PlacementResult[GunPortals.Colour.BOTH.size()];
    private SimState asked;
    private List<PortalPreview> previews = List.of();
    private GunPortals.Colour lastShot = GunPortals.Colour.SECOND;

    ShotPreviews(Simulation simulation) {
        this.simulation = simulation;
    }

    /** Follows a tick that ended in this state. */
    void after(SimState state) {
        if (state.world().trace().events().isEmpty()) {
            return;
        }
        for (TickEvent event : state.world().trace().events()) {
            if (event instanceof TickEvent.PortalOpened opened) {
                lastShot = opened.shot();
            }
        }
    }

    /**
     * Returns the previews of the portals that shots would open; if both are at one place, that of the shot not fired
     * last.
     */
    List<PortalPreview> previews(SimState state) {
        ask(state);
        return previews;
    }

    /** Returns a half of the crosshair, {@code null} without a gun. */
    CrosshairState.Half half(SimState state, GunPortals.Colour shot) {
        ask(state);
        PlacementResult would = placed[shot.ordinal()];
        if (would == null) {
            return null;
        }
        boolean made = state.world().shots().portal(shot) != GunPortals.UNFIRED;
        boolean opens = would instanceof PlacementResult.Fits;
        return new CrosshairState.Half(
                made ? CrosshairState.Portal.MADE : CrosshairState.Portal.NONE,
                opens ? CrosshairState.Shot.OPENS : CrosshairState.Shot.REFUSED);
    }

    private void ask(SimState state) {
        if (asked == state) {
            return;
        }
        asked = state;
        placed[0] = simulation.aim(state, GunPortals.Colour.FIRST);
        placed[1] = simulation.aim(state, GunPortals.Colour.SECOND);
        previews = outlines(state);
    }

    private List<PortalPreview> outlines(SimState state) {
        if (!(placed[0] instanceof PlacementResult.Fits) && !(placed[1] instanceof PlacementResult.Fits)) {
            return List.of();
        }
        List<PortalPreview> all = new ArrayList<>(2);
        for (GunPortals.Colour shot : GunPortals.Colour.BOTH) {
            Portal portal = placed[shot.ordinal()] instanceof PlacementResult.Fits fits ? fits.portal() : null;
            if (portal != null && !isThereAlready(state, shot, portal)) {
                all.add(new PortalPreview(portal, shot.ordinal()));
            }
        }
        if (all.size() == 2 && areOnePlace(all.get(0).portal(), all.get(1).portal())) {
            all.remove(lastShot.ordinal());
        }
        return List.copyOf(all);
    }

    private static boolean isThereAlready(SimState state, GunPortals.Colour shot, Portal portal) {
        int own = state.world().shots().portal(shot);
        return own != GunPortals.UNFIRED
                && areOnePlace(portal, state.world().portals().portal(own));
    }

    private static boolean areOnePlace(Portal a, Portal b) {
        return a.centre().toVector().distance(b.centre().toVector()) < SAME_PLACE_METRES
                && a.normal().toVector().dot(b.normal().toVector()) > 0.99;
    }
}
