package nephele.host.playthrough;

import java.util.ArrayList;
import java.util.List;
import nephele.engine.collision.rigid.body.Bodies;
import nephele.engine.math.Vec3;
import nephele.engine.portal.Portal;
import nephele.engine.portal.placement.PlacementResult;
import nephele.engine.portal.placement.PlacementResult.Refusal;
import nephele.engine.scene.FrameState;
import nephele.engine.sim.Simulation;
import nephele.engine.sim.state.GunPortals;
import nephele.engine.sim.state.PlayerState;
import nephele.engine.sim.state.SimState;
import nephele.engine.sim.state.TickEvent;
import nephele.engine.sim.state.WorldState;

/**
 * The result that each shot would have in the last state: computed at most once a tick, and only if a frame shows it
 * and something moved since. Ground that is too uneven takes the longest to search: it is searched once for both shots,
 * and at most {@link #SEARCHES_PER_SECOND} times a second.
 */
final class ShotPreviews {
    /** Distance below which two portals are at one place, so that one preview is enough. */
    private static final double SAME_PLACE_METRES = 0.05;

    static final int SEARCHES_PER_SECOND = 30;

    /** Greatest motion of the eye, along each axis, for which an earlier preview is shown. */
    private static final double STILL_METRES = 1e-4;

    /** Portals farther than this from the aimed point leave a shot at it as it is. */
    private static final double APART_METRES = 8;

    private final Simulation simulation;
    private final PlacementResult[] placed = new PlacementResult[GunPortals.Colour.BOTH.size()];
    private final CrosshairState.Half[] halves = new CrosshairState.Half[GunPortals.Colour.BOTH.size()];
    private SimState asked;
    private List<FrameState.PortalPreview> previews = List.of();
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
    List<FrameState.PortalPreview> previews(SimState state) {
        ask(state);
        return previews;
    }

    /** Returns a half of the crosshair, {@code null} without a gun. */
    CrosshairState.Half half(SimState state, GunPortals.Colour shot) {
        ask(state);
        return halves[shot.ordinal()];
    }

    private CrosshairState.Half madeHalf(SimState state, GunPortals.Colour shot) {
        PlacementResult would = placed[shot.ordinal()];
        if (would == null) {
            return null;
        }
        boolean made = state.world().shots().portal(shot) != GunPortals.UNFIRED;
        boolean opens = would instanceof PlacementResult.Fits;
        return new CrosshairState.Half(
                made,
                opens ? CrosshairState.Shot.OPENS : CrosshairState.Shot.REFUSED,
                isUneven(would)
                        ? PlacementResult.Refused.millimetres(((PlacementResult.Refused) would).unevenMetres())
                        : 0);
    }

    private static boolean isUneven(PlacementResult result) {
        return result instanceof PlacementResult.Refused refused && refused.reason() == Refusal.NOT_FLAT;
    }

    private void ask(SimState state) {
        if (asked == state || asked != null && isAnswered(state)) {
            return;
        }
        asked = state;
        placed[0] = simulation.aim(state, GunPortals.Colour.FIRST);
        placed[1] = isUneven(placed[0]) && isFarFromShots(state, ((PlacementResult.Refused) placed[0]).where())
                ? placed[0]
                : simulation.aim(state, GunPortals.Colour.SECOND);
        previews = outlines(state);
        for (GunPortals.Colour shot : GunPortals.Colour.BOTH) {
            halves[shot.ordinal()] = madeHalf(state, shot);
        }
    }

    /** Returns true if the earlier answers are good enough for a state. */
    private boolean isAnswered(SimState state) {
        WorldState then = asked.world();
        WorldState now = state.world();
        if (then.portals() != now.portals() || !then.shots().equals(now.shots())) {
            return false;
        }
        long ticks = state.tick() - asked.tick();
        boolean isRecent = ticks * SEARCHES_PER_SECOND < simulation.settings().ticksPerSecond();
        return isUneven(placed[0]) && isRecent || isStill(asked.player(), state.player()) && areAsleep(now.bodies());
    }

    /** Returns true if the player's eye has not moved nor turned; allocates nothing. */
    private static boolean isStill(PlayerState then, PlayerState now) {
        Vec3 from = then.feet();
        Vec3 to = now.feet();
        return then.heading().equals(now.heading())
                && then.tilt().equals(now.tilt())
                && then.stance() == now.stance()
                && Math.abs(then.eyeMetres() - now.eyeMetres()) <= STILL_METRES
                && Math.abs(from.x() - to.x()) <= STILL_METRES
                && Math.abs(from.y() - to.y()) <= STILL_METRES
                && Math.abs(from.z() - to.z()) <= STILL_METRES;
    }

    private static boolean areAsleep(Bodies bodies) {
        for (int i = 0; i < bodies.size(); i++) {
            if (!bodies.isAsleep(i)) {
                return false;
            }
        }
        return true;
    }

    /** Returns true if no shot's portal is near a place, so that both shots are alike there. */
    private static boolean isFarFromShots(SimState state, Vec3 where) {
        for (GunPortals.Colour shot : GunPortals.Colour.BOTH) {
            int portal = state.world().shots().portal(shot);
            if (portal != GunPortals.UNFIRED
                    && state.world()
                                    .portals()
                                    .portal(portal)
                                    .centre()
                                    .minus(where)
                                    .length()
                            < APART_METRES) {
                return false;
            }
        }
        return true;
    }

    private List<FrameState.PortalPreview> outlines(SimState state) {
        if (!(placed[0] instanceof PlacementResult.Fits) && !(placed[1] instanceof PlacementResult.Fits)) {
            return List.of();
        }
        List<FrameState.PortalPreview> all = new ArrayList<>(2);
        for (GunPortals.Colour shot : GunPortals.Colour.BOTH) {
            Portal portal = placed[shot.ordinal()] instanceof PlacementResult.Fits fits ? fits.portal() : null;
            if (portal != null && !isThereAlready(state, shot, portal)) {
                all.add(new FrameState.PortalPreview(portal, shot.ordinal()));
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
