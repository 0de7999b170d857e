package nephele.engine.render.pass.terrain;

import java.nio.ByteBuffer;
import nephele.engine.math.heightfield.HeightField;
import nephele.engine.render.gl.GlContext;
import nephele.engine.render.gl.GlObject;
import nephele.engine.render.gl.PixelFormat;
import nephele.engine.render.gl.Sampling;
import nephele.engine.render.gl.Texture;
import nephele.engine.render.gl.shader.TextureUnit;
import nephele.engine.render.resource.TerrainMesh;
import nephele.engine.scene.light.TerrainSky;

/** The sky visibility of a terrain on the GPU. */
final class GroundSky implements GlObject {
    private final TerrainSky open;
    private final Texture texture;

    GroundSky(GlContext gl, HeightField field) {
        open = TerrainMesh.mostSimilar(gl.shared().all(GroundSky.class), sky -> sky.open.field(), field)
                .map(sky -> TerrainSky.edited(sky.open, field))
                .orElseGet(() -> TerrainSky.of(field));
        texture = new Texture(
                gl,
                "terrain sky visibility",
                Texture.Shape.FLAT,
                PixelFormat.R8,
                Texture.Extent.flat(open.columns(), open.rows()),
                Sampling.LINEAR_CLAMP);
        byte[] values = open.values();
        ByteBuffer texels = ByteBuffer.allocateDirect(values.length);
        texture.upload(0, texels.put(values).flip());
    }

    void bind() {
        texture.bind(TextureUnit.SKY_VISIBILITY);
    }

    @Override
    public void close() {
        texture.close();
    }
}
