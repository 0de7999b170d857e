package nephele.engine.render.pass.rim;

import java.util.ArrayList;
import java.util.List;
import nephele.engine.math.Basis;
import nephele.engine.math.Vec3;
import nephele.engine.portal.Portal;
import nephele.engine.portal.Portals;
import nephele.engine.render.gl.shader.Uniforms.IfRead;
import nephele.engine.render.gl.shader.Uniforms.Vector3;
import nephele.engine.render.gl.shader.Uniforms.Vector4;
import nephele.engine.scene.FrameState;
import nephele.engine.scene.Opening;
import nephele.engine.scene.View;

/** The appearance of one rim in a view; one object, filled again for each. */
final class RimLook {
    /** Period of animations, so that floats stay exact enough in play of any length. */
    private static final double REPEAT_SECONDS = 3600;

    /** The third pattern is for portals that were not shot. */
    private static final int OF_LEVEL = 2;

    private static final Vec3 SILVER = new Vec3(0.3, 0.33, 0.36);

    private static final Vec3 WHITE = new Vec3(1, 1, 1);
    /** Fraction of white in a rim when it begins to open. */
    private static final double HOT_WHITE = 0.85;

    private static final double GOLDEN_RATIO = 0.6180339887498949;
    /** Fraction of the hues between blue and orange that are greens; these are used first. */
    private static final double GREENS = 0.45;

    private static final double PREVIEW_OPACITY = 0.92;

    private final List<Vec3> huesOfPairs = new ArrayList<>();

    View view;
    Portal portal;
    Vec3 centre;
    Basis frame;
    Vec3 tint;
    double openness;
    /** Below 1 while the portal appears. */
    double opacity;

    double seconds;
    /** 0 and 1 for the shots, 2 for portals and mirrors of the level. */
    int kind;

    int cells;
    /** Half of the longer side. */
    double halfMetres;

    boolean isOpen;

    /** The uniforms for the pose and appearance of one portal; its centre is relative to the eye. */
    record PortalUniforms(
            Vector4 centreAndOpenness,
            Vector3 portalRight,
            Vector3 portalUp,
            @IfRead Vector3 portalBack,
            Vector4 tintAndOpacity,
            Vector4 pattern) {}

    void putInto(PortalUniforms uniforms) {
        uniforms.centreAndOpenness.set(
                centre.x() - view.eyeX(), centre.y() - view.eyeY(), centre.z() - view.eyeZ(), openness);
        uniforms.portalRight.set(frame.right());
        uniforms.portalUp.set(frame.up());
        uniforms.portalBack.set(frame.back());
        uniforms.tintAndOpacity.set(tint.x(), tint.y(), tint.z(), opacity);
        uniforms.pattern.set(kind, cells, seconds, halfMetres);
    }

    void of(FrameState frameState, int index, View newView) {
        view = newView;
        lie(frameState.portals().portal(index));
        tint = tint(frameState, index);
        openness = frameState.openness(index);
        tint = heated(tint, 1 - openness);
        opacity = 1;
        seconds = frameState.seconds() % REPEAT_SECONDS;
        kind = Math.min(frameState.colour(index), OF_LEVEL);
        isOpen = frameState.portals().partner(index) != Portals.CLOSED;
    }

    void of(FrameState.ClosingPortal closing, FrameState frameState, View newView) {
        view = newView;
        lie(closing.portal());
        tint = frameState.shotPalette().rim(closing.colour());
        openness = closing.openness();
        opacity = 1;
        seconds = frameState.seconds() % REPEAT_SECONDS;
        kind = closing.colour();
        isOpen = false;
    }

    void of(FrameState.PortalPreview preview, FrameState frameState, View newView) {
        view = newView;
        lie(preview.portal());
        tint = frameState.shotPalette().rim(preview.colour());
        openness = 1;
        opacity = PREVIEW_OPACITY;
        seconds = frameState.seconds() % REPEAT_SECONDS;
        kind = preview.colour();
        isOpen = true;
    }

    /** Sets the appearance of a mirror without reflection. */
    void of(Opening mirror, double now, View newView) {
        view = newView;
        portal = null;
        centre = mirror.centre();
        frame = mirror.frame();
        halfMetres = Math.max(mirror.reach(1, 0), mirror.reach(0, 1));
        tint = SILVER;
        openness = 1;
        opacity = 1;
        seconds = now % REPEAT_SECONDS;
        kind = OF_LEVEL;
        isOpen = true;
    }

    /** Returns the colour of a rim that is hot from its shot: whiter. */
    private static Vec3 heated(Vec3 tint, double heat) {
        return heat <= 0 ? tint : tint.lerp(WHITE, HOT_WHITE * heat);
    }

    private void lie(Portal newPortal) {
        portal = newPortal;
        centre = portal.centre();
        frame = portal.frame();
        halfMetres = Math.max(portal.aperture().widthMetres(), portal.aperture().heightMetres()) / 2;
    }

    private Vec3 tint(FrameState frameState, int portal) {
        int colour = frameState.colour(portal);
        if (colour < OF_LEVEL) {
            return frameState.shotPalette().rim(colour);
        }
        int partner = frameState.portals().partner(portal);
        int pair = partner == Portals.CLOSED ? portal : Math.min(portal, partner);
        while (huesOfPairs.size() <= pair) {
            huesOfPairs.add(ofPair(huesOfPairs.size()));
        }
        return huesOfPairs.get(pair);
    }

    /**
     * Returns the colour of a pair, linear RGB as displayed: a hue away from the blue and orange of the shots, and far from
     * those of other pairs for any number of them.
     *
     * @param pair index among the level's pairs, with gaps
     */
    private static Vec3 ofPair(int pair) {
        double place = 0.2 + GOLDEN_RATIO * pair;
        place -= Math.floor(place);
        return hue(place < GREENS ? 0.24 + 0.24 * place / GREENS : 0.72 + 0.25 * (place - GREENS) / (1 - GREENS));
    }

    /** Returns a bright, slightly unsaturated colour. */
    private static Vec3 hue(double turns) {
        return new Vec3(channel(turns), channel(turns + 2 / 3.0), channel(turns + 1 / 3.0));
    }

    private static double channel(double turns) {
        double wave = 0.5 + 0.5 * Math.cos(2 * Math.PI * turns);
        return 0.06 + 0.84 * wave * wave;
    }

    /**
     * Returns true if the view may see a part of it: from in front, before the view's clip plane, in the picture and
     * larger than a pixel.
     */
    boolean isIn(int pictureHeight) {
        double reach = Math.hypot(
                        portal.aperture().widthMetres() / 2, portal.aperture().heightMetres() / 2)
                + 2 * RimShape.REACH_METRES;
        double x = centre.x() - view.eyeX();
        double y = centre.y() - view.eyeY();
        double z = centre.z() - view.eyeZ();
        double before = -along(portal.normal(), x, y, z);
        double depth = -view.alongBack(x, y, z);
        if (before < -RimShape.REACH_METRES || depth < -reach) {
            return false;
        }
        if (view.clip() != null && view.clip().signedDistance(centre) < -reach) {
            return false;
        }
        double halfWidth = view.projection().tanHalfWidth();
        double halfHeight = view.projection().tanHalfHeight();
        boolean large = reach * pictureHeight > 2 * Math.max(depth, reach) * halfHeight;
        return large
                && isWithin(Math.abs(view.alongRight(x, y, z)), depth, halfWidth, reach)
                && isWithin(Math.abs(view.alongUp(x, y, z)), depth, halfHeight, reach);
    }

    private static boolean isWithin(double aside, double depth, double tangent, double reach) {
        return aside - depth * tangent <= reach * Math.sqrt(1 + tangent * tangent);
    }

    private static double along(Vec3 axis, double x, double y, double z) {
        return axis.x() * x + axis.y() * y + axis.z() * z;
    }
}
