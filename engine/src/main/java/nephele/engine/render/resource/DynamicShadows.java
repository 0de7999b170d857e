package nephele.engine.render.resource;

import nephele.engine.math.Vec3;
import nephele.engine.render.frame.LightMaps;
import nephele.engine.render.frame.Target;
import nephele.engine.render.gl.GlContext;
import nephele.engine.render.gl.GlObject;
import nephele.engine.render.gl.UniformBuffer;
import nephele.engine.render.gl.shader.UniformBlock;
import nephele.engine.scene.dynamic.DynamicSunProjection;
import org.joml.Matrix4d;
import org.joml.Vector3d;

/**
 * The shadows of dynamic objects for shaders that include {@code surface-light.glsl}: defines, the block {@link
 * nephele.engine.render.gl.shader.UniformBlock#DYNAMIC_SHADE} and two depth textures in addition to those of static
 * geometry.
 */
public final class DynamicShadows implements GlObject {
    /** Layers of the punctual lights' depth texture; one float each, four to a vector. */
    private static final int MOST_LAYERS = 512;

    private static final int FLOATS = 16 + 3 * 4 + MOST_LAYERS;
    private static final int LAYERS = 16 + 3 * 4;

    private final boolean sun;
    private final boolean lights;
    private final UniformBuffer block;
    private final float[] values = new float[FLOATS];
    private final Matrix4d map = new Matrix4d();

    DynamicShadows(GlContext gl, LightMaps maps) {
        sun = maps.has(Target.DYNAMIC_SUN_SHADOW);
        lights = maps.has(Target.DYNAMIC_LIGHT_SHADOW);
        block = sun || lights ? new UniformBuffer(gl, "shadows of dynamic objects", FLOATS) : null;
    }

    public boolean sun() {
        return sun;
    }

    public boolean lights() {
        return lights;
    }

    /** Sets the current projection of the sun's map. */
    public void sunMap(DynamicSunProjection sunMap, Vec3 anchor) {
        sunMap.mapFromAnchor(anchor, map).get(values);
        float texelDepth = (float) (sunMap.texelMetres() / sunMap.depthMetres());
        put(16, sunMap.right(), texelDepth);
        put(20, sunMap.up(), texelDepth / 2);
        values[24] = sunMap.width();
        values[25] = sunMap.height();
    }

    /** Disables the sun's map while no dynamic object casts a shadow. */
    public void noSunMap() {
        values[24] = 0;
    }

    /** Sets whether a light's layer contains dynamic objects. */
    public void layer(int layer, boolean isUsed) {
        values[LAYERS + layer] = isUsed ? 1 : 0;
    }

    /** Uploads the values that were set. */
    public void upload() {
        block.upload(values);
    }

    private void put(int at, Vector3d v, float w) {
        values[at] = (float) v.x;
        values[at + 1] = (float) v.y;
        values[at + 2] = (float) v.z;
        values[at + 3] = w;
    }

    /** Binds the block; {@link LightMaps} binds the depth textures. */
    void bind() {
        if (block != null) {
            block.bind(UniformBlock.DYNAMIC_SHADE);
        }
    }

    @Override
    public void close() {
        if (block != null) {
            block.close();
        }
    }
}
