package nephele.engine.render.pass.gun;

import java.util.List;
import java.util.Set;
import nephele.engine.math.Vec3;
import nephele.engine.portal.Portal;
import nephele.engine.portal.Portals;
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
import nephele.engine.render.gl.GpuMesh;
import nephele.engine.render.gl.VertexFormat;
import nephele.engine.render.gl.VertexFormat.Attribute;
import nephele.engine.render.resource.AmbientLight;
import nephele.engine.render.resource.MaterialBlocks;
import nephele.engine.render.resource.MeteredExposure;
import nephele.engine.render.resource.SurfaceLight;
import nephele.engine.scene.GunInHand;
import nephele.engine.scene.View;
import nephele.engine.scene.dynamic.DynamicMesh.Range;
import nephele.engine.scene.dynamic.GunMesh;
import nephele.engine.scene.light.SkyProbes;
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
                    "gun", Stage.IN_VIEWS, Role.DECORATION, request -> requiredBy(request, Turn.FIRST))
            .using(SurfaceLight.RESOURCE, AmbientLight.PROBES, MeteredExposure.RESOURCE);
    public static final RenderFeature IN_OPENING = new RenderFeature(
                    "gun.opening",
                    Stage.IN_VIEWS_AFTER_OPAQUE,
                    Role.DECORATION,
                    request -> requiredBy(request, Turn.LAST))
            .using(SurfaceLight.RESOURCE, AmbientLight.PROBES, MeteredExposure.RESOURCE);

    private enum Turn {
        FIRST,
        LAST
    }

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
    private final Turn turn;
    private final GunPrograms programs;
    /** {@code null} without light of the sky. */
    private final SkyProbes sky;

    private final float[] seen = new float[SkyProbes.VALUES];
    private final Matrix3d viewFromGun = new Matrix3d();
    private final Vector3d[] axes = {new Vector3d(), new Vector3d(), new Vector3d(), new Vector3d()};
    private final Vector3d[] drawn = {new Vector3d(), new Vector3d(), new Vector3d(), new Vector3d()};

    private GunPass(LoadContext context, TargetReads reads, Turn turn) {
        this.turn = turn;
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
        programs = new GunPrograms(context, materials);
        sky = context.get(AmbientLight.PROBES);
    }

    private static List<Required> requiredBy(FrameRequest request, Turn turn) {
        boolean isHeld = request.mayShowCharacter()
                && request.level().portalGun() != null
                && request.level().observer() == null;
        TargetReads reads = request.lightMaps().gun();
        return isHeld
                ? List.of(new Required("portalGun: held by the player", context -> new GunPass(context, reads, turn)))
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
        if (gun == null || !isMain || turn != turn(frame)) {
            return;
        }
        View view = frame.view();
        place(gun, view);
        frame.surface().bind();
        Range part = frame.surface().height() < FINE_FROM_PIXELS ? model.coarse() : model.fine();
        if (turn == Turn.LAST) {
            gl.state().depthOf(DepthOf.FARTHEST);
            gl.state().set(Depth.ALWAYS_AND_WRITE_ONLY_DEPTH, Blend.REPLACE, Cull.BACK);
            programs.useDepth(drawn);
            mesh.draw(part.first(), part.count());
            gl.state().depthOf(DepthOf.SURFACE);
        }
        gl.state().set(Depth.LESS_AND_WRITE, Blend.REPLACE, Cull.BACK);
        light.bind(reads);
        materials.bind(0);
        if (sky != null) {
            sky.at(view.eyeX(), view.eyeY(), view.eyeZ(), seen, 0);
        }
        programs.use(drawn, axes, view, light.anchor(), seen);
        programs.light(gun, frame.frameState().shotPalette());
        mesh.draw(part.first(), part.count());
    }

    private static Turn turn(FrameContext frame) {
        View view = frame.view();
        Portals portals = frame.frameState().portals();
        for (int i = 0; i < portals.size(); i++) {
            Portal portal = portals.portal(i);
            double reach = Math.hypot(
                    portal.aperture().widthMetres(), portal.aperture().heightMetres());
            boolean isNear = Math.abs(portal.inFront(view.eyeX(), view.eyeY(), view.eyeZ())) < IN_OPENING_METRES;
            if (isNear && portal.centre().minus(view.eye()).length() < reach) {
                return Turn.LAST;
            }
        }
        return Turn.FIRST;
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
}
