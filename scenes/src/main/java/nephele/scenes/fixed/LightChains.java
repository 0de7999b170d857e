package nephele.scenes.fixed;

import java.nio.FloatBuffer;
import nephele.engine.render.gl.BufferTexture;
import nephele.engine.render.gl.GlContext;
import nephele.engine.render.gl.shader.TextureUnit;
import nephele.scenes.xml.PosedScene;
import org.joml.Matrix4d;
import org.joml.Matrix4dc;
import org.lwjgl.BufferUtils;

/**
 * The lights of one scene on the GPU, each linked to the next one that lights the same models. An entity's own lights
 * come first, then all lights of the surrounding scene, since the entity belongs to none of its groups.
 */
final class LightChains implements AutoCloseable {
    private final PosedScene own;
    private final PosedScene around;
    private final LightTable table;
    private final BufferTexture texels;
    private final FloatBuffer staging;
    private final Matrix4d place = new Matrix4d();

    /** @param around the scene that contains the entity {@code own}; {@code null} for none */
    LightChains(GlContext gl, PosedScene own, PosedScene around) {
        this.own = own;
        this.around = around;
        int count = own.lightCount() + (around == null ? 0 : around.lightCount());
        table = new LightTable(Math.max(1, count));
        texels = BufferTexture.changing(gl, "lights");
        staging = BufferUtils.createFloatBuffer(table.packed().length);
    }

    int firstOfModel(int model) {
        return extended(own.firstLight(model));
    }

    /** Returns the next light: where a chain of the entity ends, that of the surrounding scene begins. */
    private int extended(int light) {
        boolean goesOn = light == PosedScene.NONE && around != null && around.lightCount() > 0;
        return goesOn ? own.lightCount() : light;
    }

    /** Updates the lights from the posed scenes. */
    void update(Matrix4dc worldFromOwn) {
        for (int i = 0; i < own.lightCount(); i++) {
            worldFromOwn.mul(own.worldFromLight(i), place);
            table.put(i, own.light(i), place, extended(own.nextLight(i)));
        }
        int others = around == null ? 0 : around.lightCount();
        for (int i = 0; i < others; i++) {
            int next = i + 1 < others ? own.lightCount() + i + 1 : PosedScene.NONE;
            table.put(own.lightCount() + i, around.light(i), around.worldFromLight(i), next);
        }
        texels.upload(staging.clear().put(table.packed()).flip());
    }

    void bind() {
        texels.bind(TextureUnit.SCENE_LIGHTS);
    }

    @Override
    public void close() {
        texels.close();
    }
}
