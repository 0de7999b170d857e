package nephele.engine.render.pass.gun;

import nephele.engine.math.Vec3;
import nephele.engine.render.frame.Defines;
import nephele.engine.render.frame.LoadContext;
import nephele.engine.render.resource.MeteredExposure;
import nephele.engine.render.resource.SurfaceLight;
import nephele.engine.render.resource.SurfaceVariant;
import nephele.engine.render.gl.GlProgram;
import nephele.engine.render.gl.shader.ShaderSource;
import nephele.engine.render.gl.shader.Uniforms;
import nephele.engine.render.gl.shader.Uniforms.Vector3;
import nephele.engine.render.gl.shader.Uniforms.Vector4;
import nephele.engine.render.frame.FrameUniforms;
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

    private static final String[] DRAWN = {"drawnRight", "drawnUp", "drawnBack", "drawnPlace"};
    private static final String[] LIT = {"gunRight", "gunUp", "gunBack"};

    /**
     * The uniforms of the lit surface.
     *
     * @param eyeFromAnchor {@code null} if no light depends on the place
     * @param skyAhead {@code null} without light of the sky, {@code skyBehind} likewise
     */
    private record Lit(
            Vector3[] drawn,
            Vector3[] axes,
            Vector3 lamp,
            Vector4 mark,
            Vector3 flash,
            Vector3 eyeFromAnchor,
            Vector3 skyAhead,
            Vector3 skyBehind) {}

    private final GlProgram<Vector3[]> depth;
    private final GlProgram<Lit> lit;

    GunPrograms(LoadContext context, int materialsPerBlock) {
        var onlyDepth = Defines.of(context).with("ONLY_DEPTH").values();
        depth = new GlProgram<>(
                context.gl(),
                ShaderSource.load(FOLDER + "gun.vert", onlyDepth),
                ShaderSource.load(FOLDER + "depth.frag", onlyDepth),
                uniforms -> vectors(uniforms, DRAWN));
        SurfaceLight light = context.get(SurfaceLight.RESOURCE);
        SurfaceVariant surface = SurfaceVariant.of(KIND, context.quality());
        var defines = surface.addTo(light.addForGun(Defines.of(context)), materialsPerBlock)
                .with("FIRST_LAMP", GunMesh.FIRST_LAMP)
                .values();
        lit = new GlProgram<>(
                context.gl(),
                ShaderSource.load(FOLDER + "gun.vert", defines),
                ShaderSource.load(FOLDER + "gun.frag", defines),
                uniforms -> {
                    surface.set(uniforms);
                    light.tieForGun(uniforms);
                    MeteredExposure.tieInView(context, uniforms);
                    return new Lit(
                            vectors(uniforms, DRAWN),
                            vectors(uniforms, LIT),
                            uniforms.vector3("lamp"),
                            uniforms.vector4("secondMark"),
                            uniforms.vector3("flash"),
                            ifRead(uniforms, "eyeFromAnchor"),
                            ifRead(uniforms, "skySeenAhead"),
                            ifRead(uniforms, "skySeenBehind"));
                });
    }

    private static Vector3[] vectors(Uniforms uniforms, String[] names) {
        Vector3[] all = new Vector3[names.length];
        for (int i = 0; i < names.length; i++) {
            all[i] = uniforms.vector3(names[i]);
        }
        return all;
    }

    private static Vector3 ifRead(Uniforms uniforms, String name) {
        return uniforms.reads(name) ? uniforms.vector3(name) : null;
    }

    /** Uses the program that draws only depth. */
    void useDepth(Vector3d[] drawn) {
        depth.use();
        set(depth.uniforms(), drawn);
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
        set(places.drawn, drawn);
        set(places.axes, axes);
        if (places.eyeFromAnchor != null) {
            places.eyeFromAnchor.set((float) (view.eyeX() - anchor.x()), (float) (view.eyeY() - anchor.y()), (float)
                    (view.eyeZ() - anchor.z()));
        }
        if (places.skyAhead != null) {
            places.skyAhead.set(sky[0], sky[1], sky[2]);
            places.skyBehind.set(sky[3], sky[4], sky[5]);
        }
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
        places.mark.set((float) second.x(), (float) second.y(), (float) second.z(), (float) share);
        Vec3 shot = palette.rim(gun.flashColour());
        double bright = FLASH * gun.flash();
        places.flash.set((float) (bright * shot.x()), (float) (bright * shot.y()), (float) (bright * shot.z()));
    }

    private static void set(Vector3[] uniforms, Vector3d[] values) {
        for (int i = 0; i < uniforms.length; i++) {
            uniforms[i].set((float) values[i].x, (float) values[i].y, (float) values[i].z);
        }
    }
}
