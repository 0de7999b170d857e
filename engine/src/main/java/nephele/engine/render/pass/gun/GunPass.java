package nephele.engine.render.pass.gun;

import java.util.List;
import java.util.Set;
import nephele.engine.math.Vec3;
import nephele.engine.portal.Portal;
import nephele.engine.portal.Portals;
import nephele.engine.render.frame.Defines;
import nephele.engine.render.frame.FrameContext;
import nephele.engine.render.frame.FrameRequest;
import nephele.engine.render.frame.LoadContext;
import nephele.engine.render.frame.Pass;
import nephele.engine.render.frame.RenderFeature;
import nephele.engine.render.frame.RenderFeature.Role;
import nephele.engine.render.frame.Required;
import nephele.engine.render.frame.Stage;
import nephele.engine.render.frame.Target;
import nephele.engine.render.frame.TargetReads;
import nephele.engine.render.gl.DrawState.Blend;
import nephele.engine.render.gl.DrawState.Cull;
import nephele.engine.render.gl.DrawState.Depth;
import nephele.engine.render.gl.DrawState.DepthOf;
import nephele.engine.render.gl.GlContext;
import nephele.engine.render.gl.GlProgram;
import nephele.engine.render.gl.GpuMesh;
import nephele.engine.render.gl.VertexFormat;
import nephele.engine.render.gl.VertexFormat.Attribute;
import nephele.engine.render.gl.shader.Uniforms.IfRead;
import nephele.engine.render.gl.shader.Uniforms.Vector3;
import nephele.engine.render.gl.shader.Uniforms.Vector4;
import nephele.engine.render.resource.AmbientLight;
import nephele.engine.render.resource.MaterialBlocks;
import nephele.engine.render.resource.MeteredExposure;
import nephele.engine.render.resource.SurfaceLight;
import nephele.engine.scene.GunInHand;
import nephele.engine.scene.ShotPalette;
import nephele.engine.scene.SolidBatch;
import nephele.engine.scene.View;
import nephele.engine.scene.dynamic.DynamicMesh.Range;
import nephele.engine.scene.dynamic.GunMesh;
import nephele.engine.scene.probe.SkyProbes;
import org.joml.Matrix3d;
import org.joml.Vector3d;

/**
 * Draws the gun over everything else in the main view, in depths that nothing else has: walls never cut it. It is drawn
 * first, so that what it hides costs nothing; only while the eye is in an opening, which then has the least depth there
 * is, it is drawn last and replaces that. It is lit by the level's light near the eye; the character's own shadow, in
 * which the eye always is, does not fall on it. The path tracer and pictures of a level without its player do not know it.
 */
public final class GunPass implements Pass {
    public static final RenderFeature FEATURE = new RenderFeature(
                    "gun", Stage.IN_VIEWS, Role.DECORATION, request -> requiredBy(request, false))
            .using(SurfaceLight.RESOURCE, AmbientLight.PROBES, MeteredExposure.RESOURCE);
    public static final RenderFeature IN_OPENING = new RenderFeature(
                    "gun.opening", Stage.IN_VIEWS_AFTER_OPAQUE, Role.DECORATION, request -> requiredBy(request, true))
            .using(SurfaceLight.RESOURCE, AmbientLight.PROBES, MeteredExposure.RESOURCE);

    private static final String FOLDER = "/nephele/engine/render/pass/gun/";
    private static final SolidBatch.Kind KIND = new SolidBatch.Kind(false, -1, -1, 0);

    /** Brightness of a flash at its greatest, as displayed. */
    private static final double FLASH = 1.6;

    /** Distance of the eye from an opening's plane below which it may be drawn nearer than the near plane. */
    private static final double IN_OPENING_METRES = 0.3;

    /** Height of the picture from which on the fine mesh is drawn, pixels. */
    private static final int FINE_FROM_PIXELS = 500;

    private static final VertexFormat FORMAT = VertexFormat.of(Attribute.FLOAT3, Attribute.INT16X4, Attribute.FLOAT2);

    private final GlContext gl;
    private final SurfaceLight light;
    private final TargetReads reads;
    private final MaterialBlocks materials;
    private final GpuMesh mesh;
    private final GunMesh.Model model;
    /** Whether it draws while the eye is in an opening. */
    private final boolean isInOpening;

    private final GlProgram<Drawn> depth;
    private final GlProgram<Lit> lit;
    /** {@code null} without light of the sky and baked light. */
    private final SkyProbes sky;

    /** The light around the eye, as of {@link SkyProbes}. */
    private final float[] around = new float[SkyProbes.LIT_VALUES];

    private final Matrix3d viewFromGun = new Matrix3d();
    private final Vector3d[] axes = {new Vector3d(), new Vector3d(), new Vector3d(), new Vector3d()};
    private final Vector3d[] drawn = {new Vector3d(), new Vector3d(), new Vector3d(), new Vector3d()};

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
            @IfRead Vector3 skySeenBehind,
            @IfRead List<Vector3> bounced) {}

    private GunPass(LoadContext context, TargetReads reads, boolean isInOpening) {
        this.isInOpening = isInOpening;
        this.reads = reads;
        gl = context.gl();
        light = context.get(SurfaceLight.RESOURCE);
        materials = context.own(new MaterialBlocks(gl, GunMesh.materials()));
        model = GunMesh.make();
        mesh = context.share(
                GpuMesh.class,
                "gun",
                () -> new GpuMesh(
                        gl, "gun", FORMAT, model.mesh().vertices(), model.mesh().indices()));
        var onlyDepth = Defines.of(context).with("ONLY_DEPTH").values();
        depth = GlProgram.of(gl, FOLDER + "gun.vert", FOLDER + "depth.frag", onlyDepth, Drawn.class);
        MeteredExposure.readInViews(context);
        var defines = materials
                .addTo(light.addBounced(light.addForGun(Defines.of(context))), KIND, context.quality())
                .with("FIRST_LAMP", GunMesh.FIRST_LAMP)
                .values();
        lit = GlProgram.of(gl, FOLDER + "gun.vert", FOLDER + "gun.frag", defines, Lit.class);
        sky = context.get(AmbientLight.PROBES);
    }

    private static List<Required> requiredBy(FrameRequest request, boolean isInOpening) {
        boolean isHeld = request.mayShowCharacter()
                && request.level().portalGun() != null
                && request.level().observer() == null;
        TargetReads reads = request.lightMaps().gun();
        return isHeld
                ? List.of(new Required(
                        "portalGun: held by the player", context -> new GunPass(context, reads, isInOpening)))
                : List.of();
    }

    @Override
    public Set<Target> reads() {
        return reads.declared();
    }

    @Override
    public void draw(FrameContext frame) {
        GunInHand gun = frame.frameState().gun();
        boolean isMain = frame.node() == null || frame.node().parent() == null;
        if (gun == null || !isMain || isInOpening != isInOpening(frame)) {
            return;
        }
        View view = frame.view();
        place(gun, view);
        frame.surface().bind();
        Range part = frame.surface().height() < FINE_FROM_PIXELS ? model.coarse() : model.fine();
        if (isInOpening) {
            gl.state().depthOf(DepthOf.FARTHEST);
            gl.state().set(Depth.ALWAYS_AND_WRITE_ONLY_DEPTH, Blend.REPLACE, Cull.BACK);
            depth.use();
            depth.uniforms().set(drawn);
            mesh.draw(part.first(), part.count());
            gl.state().depthOf(DepthOf.SURFACE);
        }
        gl.state().set(Depth.LESS_AND_WRITE, Blend.REPLACE, Cull.BACK);
        light.bind(reads);
        materials.bind(0);
        if (sky != null) {
            sky.at(view.eyeX(), view.eyeY(), view.eyeZ(), around, 0);
        }
        lit.use();
        lit.uniforms().drawn.set(drawn);
        setLight(view);
        setColours(gun, frame.frameState().shotPalette());
        mesh.draw(part.first(), part.count());
    }

    private static boolean isInOpening(FrameContext frame) {
        View view = frame.view();
        Portals portals = frame.frameState().portals();
        for (int i = 0; i < portals.size(); i++) {
            Portal portal = portals.portal(i);
            double reach = Math.hypot(
                    portal.aperture().widthMetres(), portal.aperture().heightMetres());
            boolean isNear = Math.abs(portal.inFront(view.eyeX(), view.eyeY(), view.eyeZ())) < IN_OPENING_METRES;
            if (isNear && portal.centre().minus(view.eye()).length() < reach) {
                return true;
            }
        }
        return false;
    }

    /** Computes the gun's axes and its origin relative to the eye, in world directions. */
    private void place(GunInHand gun, View view) {
        double wide = GunInHand.widening(view.projection().tanHalfHeight());
        viewFromGun.rotationY(gun.yawRadians()).rotateX(gun.pitchRadians()).rotateZ(-gun.rollRadians());
        for (int axis = 0; axis < 3; axis++) {
            Vector3d a = viewFromGun.getColumn(axis, axes[axis]);
            view.direction(wide * a.x, wide * a.y, a.z, drawn[axis]);
            view.direction(a.x, a.y, a.z, a);
        }
        Vec3 at = gun.place();
        double right = gun.rightMetres(view.projection().aspect());
        view.direction(wide * right, wide * at.y(), at.z(), drawn[3]);
    }

    /** Sets what the light on the surface depends on. */
    private void setLight(View view) {
        Lit uniforms = lit.uniforms();
        put(uniforms.gunRight, axes[0]);
        put(uniforms.gunUp, axes[1]);
        put(uniforms.gunBack, axes[2]);
        Vec3 anchor = light.anchor();
        uniforms.eyeFromAnchor.set(view.eyeX() - anchor.x(), view.eyeY() - anchor.y(), view.eyeZ() - anchor.z());
        uniforms.skySeenAhead.set(around[0], around[1], around[2]);
        uniforms.skySeenBehind.set(around[3], around[4], around[5]);
        for (int i = 0; i < uniforms.bounced.size(); i++) {
            int at = SkyProbes.VALUES + 3 * i;
            uniforms.bounced.get(i).set(around[at], around[at + 1], around[at + 2]);
        }
    }

    /** Sets the colours of the lamps and of a shot's flash. */
    private void setColours(GunInHand gun, ShotPalette palette) {
        Lit uniforms = lit.uniforms();
        Vec3 first = palette.rim(0);
        Vec3 second = palette.rim(1);
        double secondWeight = gun.secondShare();
        uniforms.lamp.set(
                (float) (first.x() + secondWeight * (second.x() - first.x())),
                (float) (first.y() + secondWeight * (second.y() - first.y())),
                (float) (first.z() + secondWeight * (second.z() - first.z())));
        uniforms.secondMark.set((float) second.x(), (float) second.y(), (float) second.z(), (float) secondWeight);
        Vec3 shot = palette.rim(gun.flashColour());
        double bright = FLASH * gun.flash();
        uniforms.flash.set((float) (bright * shot.x()), (float) (bright * shot.y()), (float) (bright * shot.z()));
    }

    private static void put(Vector3 uniform, Vector3d value) {
        uniform.set(value.x, value.y, value.z);
    }
}
