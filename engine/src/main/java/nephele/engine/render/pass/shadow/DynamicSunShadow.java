package nephele.engine.render.pass.shadow;

import nephele.engine.math.Frustum;
import nephele.engine.math.Vec3;
import nephele.engine.render.frame.FrameContext;
import nephele.engine.render.frame.LoadContext;
import nephele.engine.render.frame.Target;
import nephele.engine.render.gl.GlContext;
import nephele.engine.render.gl.PixelFormat;
import nephele.engine.render.gl.RenderTarget;
import nephele.engine.render.gl.Sampling;
import nephele.engine.render.gl.Texture;
import nephele.engine.render.resource.DynamicMeshes;
import nephele.engine.render.resource.DynamicShadows;
import nephele.engine.render.resource.SurfaceLight;
import nephele.engine.scene.dynamic.DynamicSunProjection;
import nephele.engine.scene.dynamic.VisibleInstances;
import org.joml.Matrix4d;

/** The sun's depth map of dynamic objects. */
final class DynamicSunShadow {
    /** Ratio of the static map's side length in metres to this map's. */
    private static final int SIDE_DIVISOR = 4;

    private final Frustum everything = Frustum.everything();
    private final GlContext gl;
    private final DynamicMeshes meshes;
    private final SurfaceLight light;
    private final DynamicShadows shade;
    private final Vec3 anchor;
    private final DynamicSunProjection sunMap;
    private final RenderTarget target;
    private final VisibleInstances visible;
    private final Matrix4d matrix = new Matrix4d();

    DynamicSunShadow(LoadContext context, DynamicMeshes meshes) {
        gl = context.gl();
        this.meshes = meshes;
        light = context.get(SurfaceLight.RESOURCE);
        shade = light.dynamicShadows();
        anchor = light.anchor();
        int side = Math.max(256, context.quality().shadowTexels() / SIDE_DIVISOR);
        sunMap = new DynamicSunProjection(side);
        Texture.Extent extent = new Texture.Extent(side, side, 1);
        Texture map = context.own(new Texture(
                gl,
                "sun shadow of dynamic objects",
                Texture.Shape.ARRAY,
                PixelFormat.DEPTH32F,
                extent,
                Sampling.NEAREST_CLAMP));
        target = context.own(RenderTarget.depthLayer(gl, "sun shadow of dynamic objects", map, 0));
        visible = new VisibleInstances(meshes.dynamicObjects(), meshes.copies());
        context.targets().put(Target.DYNAMIC_SUN_SHADOW, map);
    }

    /**
     * Redraws the map if its content differs: other objects, another sun, or a far eye position.
     *
     * @return true if it was redrawn
     */
    boolean follow(DynamicDepthDraw depth, FrameContext frame, boolean haveMoved) {
        Vec3 towardsSun = light.towardsSun();
        Vec3 eye = frame.view().eye();
        if (!haveMoved && towardsSun.equals(sunMap.towardsSun()) && !sunMap.isOutgrown(eye)) {
            return false;
        }
        draw(depth, towardsSun, eye);
        return true;
    }

    private void draw(DynamicDepthDraw depth, Vec3 towardsSun, Vec3 eye) {
        sunMap.turn(towardsSun);
        sunMap.fit(meshes.copies(), eye);
        if (sunMap.width() == 0) {
            shade.noSunMap();
            return;
        }
        shade.sunMap(sunMap, anchor);
        gl.state().scissor(0, 0, sunMap.width(), sunMap.height());
        target.clearDepth();
        visible.find(everything, eye, 1 / sunMap.texelMetres());
        sunMap.mapFromAnchor(anchor, matrix);
        depth.drawParallel(visible, clip(matrix));
        gl.state().noScissor();
    }

    private static Matrix4d clip(Matrix4d map) {
        return map.scaleLocal(2, 2, 2, map).translateLocal(-1, -1, -1, map);
    }
}
