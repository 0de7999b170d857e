package nephele.engine.render.frame;

import nephele.engine.math.Vec3;
import nephele.engine.render.gl.GlContext;
import nephele.engine.render.gl.GlObject;
import nephele.engine.render.gl.TextureUnit;
import nephele.engine.render.gl.UniformBuffer;
import nephele.engine.render.gl.Uniforms;
import nephele.engine.scene.thing.ThingSunMap;
import org.joml.Matrix4d;
import org.joml.Vector3d;

/**
 * The shadows of what moves, for shaders that include {@code surface-light.glsl}: defines, the block {@code ThingShade}
 * and two more depth textures beside those of what never moves.
 */
public final class ThingShade implements GlObject {
    public static final int BINDING = 3;

    /** One float for each layer of the lamps' depth texture, four to a vector. */
    private static final int MOST_LAYERS = 512;

    private static final int FLOATS = 16 + 3 * 4 + MOST_LAYERS;
    private static final int LAYERS = 16 + 3 * 4;

    private final boolean sun;
    private final boolean lamps;
    private final UniformBuffer block;
    private final float[] values = new float[FLOATS];
    private final Matrix4d map = new Matrix4d();

    ThingShade(GlContext gl, LightMaps maps) {
        sun = maps.has(Target.THING_SUN_SHADOW);
        lamps = maps.has(Target.THING_LAMP_SHADOW);
        block = sun || lamps ? new UniformBuffer(gl, "shadows of things", FLOATS) : null;
    }

    public boolean sun() {
        return sun;
    }

    public boolean lamps() {
        return lamps;
    }

    Defines addTo(Defines defines) {
        return defines.withIf(sun, "THING_SUN_SHADOW").withIf(lamps, "THING_LAMP_SHADOW");
    }

    void tie(Uniforms uniforms) {
        if (sun) {
            uniforms.sampler("thingSunMap", TextureUnit.THING_SUN_SHADOW);
        }
        if (lamps) {
            uniforms.sampler("thingLampMaps", TextureUnit.THING_LAMP_SHADOW);
        }
        if (block != null) {
            uniforms.block("ThingShade", BINDING);
        }
    }

    /** Where the sun's map lies now. */
    public void sunMap(ThingSunMap sunMap, Vec3 anchor) {
        sunMap.mapFromAnchor(anchor, map).get(values);
        float texelDepth = (float) (sunMap.texelMetres() / sunMap.depthMetres());
        put(16, sunMap.right(), texelDepth);
        put(20, sunMap.up(), texelDepth / 2);
        values[24] = sunMap.width();
        values[25] = sunMap.height();
    }

    /** Where nothing that moves casts: the map is not asked. */
    public void noSunMap() {
        values[24] = 0;
    }

    /** Whether a lamp's layer shows anything that moves. */
    public void layer(int layer, boolean isUsed) {
        values[LAYERS + layer] = isUsed ? 1 : 0;
    }

    /** Hands what was set to the shaders. */
    public void upload() {
        block.upload(values);
    }

    private void put(int at, Vector3d v, float w) {
        values[at] = (float) v.x;
        values[at + 1] = (float) v.y;
        values[at + 2] = (float) v.z;
        values[at + 3] = w;
    }

    /** Binds the block; the depth textures are {@link LightMaps}. */
    void bind() {
        if (block != null) {
            block.bind(BINDING);
        }
    }

    @Override
    public void close() {
        if (block != null) {
            block.close();
        }
    }
}
