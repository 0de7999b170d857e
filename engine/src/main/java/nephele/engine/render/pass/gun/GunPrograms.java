package nephele.engine.render.pass.gun;

import nephele.engine.math.Vec3;
import nephele.engine.render.frame.Defines;
import nephele.engine.render.frame.LoadContext;
import nephele.engine.render.gl.GlProgram;
import nephele.engine.render.gl.shader.Uniforms.IfRead;
import nephele.engine.render.gl.shader.Uniforms.Vector3;
import nephele.engine.render.gl.shader.Uniforms.Vector4;
import nephele.engine.render.resource.MaterialBlocks;
import nephele.engine.render.resource.MeteredExposure;
import nephele.engine.render.resource.SurfaceLight;
import nephele.engine.scene.GunInHand;
import nephele.engine.scene.ShotPalette;
import nephele.engine.scene.SolidBatch;
import nephele.engine.scene.View;
import nephele.engine.scene.dynamic.GunMesh;
import org.joml.Vector3d;

/** The gun's two programs: its depth alone, and its lit surface. */
final class GunPrograms {
    private static final String FOLDER = "/nephele/engine/render/pass/gun/";
    private static final SolidBatch.Kind KIND = new SolidBatch.Kind(false, -1, -1, 0);

    /** Brightness of a flash at its greatest, as displayed. */
    private static final double FLASH = 1.6;

    /** The axes and the origin with which the gun is drawn. */
    private record Drawn(Vector3 drawnRight, Vector3 drawnUp, Vector3 drawnBack, Vector3 drawnPlace) {
        void set(Vector3d[] axesAndPlace) {
            put(drawnRight, axesAndPlace[0]);
            put(drawnUp, axesAndPlace[1]);
            put(drawnBack, axesAndPlace[2]);
            put(drawnPlace, axesAndPlace[3]);
        }
    }

    /** The uniforms of the lit surface. */
    private record Lit(
            Drawn drawn,
            Vector3 gunRight,
            Vector3 gunUp,
            Vector3 gunBack,
            Vector3 lamp,
            Vector4 secondMark,
            Vector3 flash,
            @IfRead Vector3 eyeFromAnchor,
            @IfRead Vector3 skySeenAhead,
            @IfRead Vector3 skySeenBehind) {}

    private final GlProgram<Drawn> depth;
    private final GlProgram<Lit> lit;

    GunPrograms(LoadContext context, MaterialBlocks materials) {
        var onlyDepth = Defines.of(context).with("ONLY_DEPTH").values();
        depth = GlProgram.of(context.gl(), FOLDER + "gun.vert", FOLDER + "depth.frag", onlyDepth, Drawn.class);
        MeteredExposure.readInViews(context);
        SurfaceLight light = context.get(SurfaceLight.RESOURCE);
        var defines = materials
                .addTo(light.addForGun(Defines.of(context)), KIND, context.quality())
                .with("FIRST_LAMP", GunMesh.FIRST_LAMP)
                .values();
        lit = GlProgram.of(context.gl(), FOLDER + "gun.vert", FOLDER + "gun.frag", defines, Lit.class);
    }

    /** Uses the program that draws only depth. */
    void useDepth(Vector3d[] drawn) {
        depth.use();
        depth.uniforms().set(drawn);
    }

    /**
     * Uses the program of the surface.
     *
     * @param drawn axes and origin as drawn, {@code axes} as lit
     * @param sky the visible shares of the sky, as of {@link nephele.engine.scene.light.SkyProbes}
     */
    void use(Vector3d[] drawn, Vector3d[] axes, View view, Vec3 anchor, float[] sky) {
        lit.use();
        Lit places = lit.uniforms();
        places.drawn.set(drawn);
        put(places.gunRight, axes[0]);
        put(places.gunUp, axes[1]);
        put(places.gunBack, axes[2]);
        places.eyeFromAnchor.set(view.eyeX() - anchor.x(), view.eyeY() - anchor.y(), view.eyeZ() - anchor.z());
        places.skySeenAhead.set(sky[0], sky[1], sky[2]);
        places.skySeenBehind.set(sky[3], sky[4], sky[5]);
    }

    /** Sets the colours of the lamps and of a shot's flash. */
    void light(GunInHand gun, ShotPalette palette) {
        Lit places = lit.uniforms();
        Vec3 first = palette.rim(0);
        Vec3 second = palette.rim(1);
        double share = gun.secondShare();
        places.lamp.set(
                (float) (first.x() + share * (second.x() - first.x())),
                (float) (first.y() + share * (second.y() - first.y())),
                (float) (first.z() + share * (second.z() - first.z())));
        places.secondMark.set((float) second.x(), (float) second.y(), (float) second.z(), (float) share);
        Vec3 shot = palette.rim(gun.flashColour());
        double bright = FLASH * gun.flash();
        places.flash.set((float) (bright * shot.x()), (float) (bright * shot.y()), (float) (bright * shot.z()));
    }

    private static void put(Vector3 uniform, Vector3d value) {
        uniform.set(value.x, value.y, value.z);
    }
}
