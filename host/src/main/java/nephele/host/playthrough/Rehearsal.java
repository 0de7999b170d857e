package nephele.host.playthrough;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import nephele.engine.level.Level;
import nephele.engine.level.PortalSpec;
import nephele.engine.math.Vec3;
import nephele.engine.portal.Aperture;
import nephele.engine.portal.Portal;
import nephele.engine.portal.Portals;
import nephele.engine.scene.FrameState;
import nephele.engine.scene.MuzzleLight;
import nephele.engine.scene.View;
import org.joml.Quaterniond;

/**
 * A state of a level in which what the player brings about later is in view at once: two open portals and what is seen
 * through them, the lights of shots, a body held in front of the eye. A frame of it is drawn while the level is loaded
 * and shown to nobody, so that the driver compiles its programs then and not at the first shot.
 */
public final class Rehearsal {
    private static final double PORTAL_AHEAD_METRES = 0.6;
    private static final double BODY_AHEAD_METRES = 1.5;
    private static final double HALF_OPEN = 0.5;

    private Rehearsal() {}

    /**
     * Returns the state for a view of a level; empty if the level has neither portals nor a portal gun.
     *
     * @param begun the state in which the level begins
     */
    public static Optional<FrameState> of(Level level, View view, FrameState begun) {
        Optional<Aperture> aperture = aperture(level);
        if (aperture.isEmpty()) {
            return Optional.empty();
        }
        FrameState all = FrameState.atStart(level);
        all.seconds(begun.seconds());
        all.environment(begun.environment());
        all.shotPalette(begun.shotPalette());
        all.observer(begun.observer());
        openPortals(all, view, aperture.get());
        if (level.portalGun() != null) {
            shoot(all, view, begun);
        }
        if (begun.character() != null) {
            all.character(begun.character().at(ahead(view, BODY_AHEAD_METRES)));
        }
        if (all.bodies() > 0) {
            all.body(0, ahead(view, BODY_AHEAD_METRES).toVector(), new Quaterniond());
            all.held(0, new Vec3(0, 0, -BODY_AHEAD_METRES), 1);
        }
        return Optional.of(all);
    }

    private static Optional<Aperture> aperture(Level level) {
        if (level.portalGun() != null) {
            var gun = level.portalGun();
            return Optional.of(Aperture.of(gun.shape(), gun.widthMetres(), gun.heightMetres()));
        }
        return level.portals().stream().findFirst().map(Rehearsal::aperture);
    }

    private static Aperture aperture(PortalSpec spec) {
        return Aperture.of(spec.shape(), spec.widthMetres(), spec.heightMetres());
    }

    /** Adds two linked portals back to back before the eye, which make a window: it shows what is behind it. */
    private static void openPortals(FrameState all, View view, Aperture aperture) {
        Portals own = all.portals();
        List<Portal> portals = new ArrayList<>();
        List<Integer> partners = new ArrayList<>();
        for (int i = 0; i < own.size(); i++) {
            portals.add(own.portal(i));
            partners.add(own.partner(i));
        }
        Vec3 centre = ahead(view, PORTAL_AHEAD_METRES);
        partners.add(own.size() + 1);
        partners.add(own.size());
        portals.add(new Portal("rehearsal", centre, Portal.facing(view.back(), view.up()), aperture));
        portals.add(new Portal("rehearsal", centre, Portal.facing(view.back().negated(), view.up()), aperture));
        all.portals(new Portals(portals, partners));
        all.setPortalLook(own.size(), 0, 1);
        all.setPortalLook(own.size() + 1, 1, 1);
    }

    private static Vec3 ahead(View view, double metres) {
        return view.eye().addScaled(-metres, view.back());
    }

    private static void shoot(FrameState all, View view, FrameState begun) {
        Portal window = all.portals().portal(all.portals().size() - 2);
        Vec3 place = window.centre();
        all.gun(begun.gun());
        all.previews(List.of(new FrameState.PortalPreview(window, 0), new FrameState.PortalPreview(window, 1)));
        all.closing(List.of(new FrameState.ClosingPortal(window, 1, HALF_OPEN)));
        all.shotEffects(List.of(
                new FrameState.ShotEffect(
                        FrameState.ShotEffect.Kind.BOLT, 0, HALF_OPEN, place, place.plus(view.right())),
                new FrameState.ShotEffect(
                        FrameState.ShotEffect.Kind.SHIMMER, 1, HALF_OPEN, place, place.plus(view.back()))));
        all.muzzleLight(new MuzzleLight(view.eye(), 0, 1));
    }
}
