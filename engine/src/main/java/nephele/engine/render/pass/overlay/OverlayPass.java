package nephele.engine.render.pass.overlay;

import java.nio.ByteBuffer;
import java.util.Map;
import nephele.engine.asset.Picture;
import nephele.engine.render.gl.DrawState.Blend;
import nephele.engine.render.gl.DrawState.Cull;
import nephele.engine.render.gl.DrawState.Depth;
import nephele.engine.render.gl.GlContext;
import nephele.engine.render.gl.GlProgram;
import nephele.engine.render.gl.PixelFormat;
import nephele.engine.render.gl.QuadStream;
import nephele.engine.render.gl.RenderTarget;
import nephele.engine.render.gl.Sampling;
import nephele.engine.render.gl.Texture;
import nephele.engine.render.gl.VertexFormat;
import nephele.engine.render.gl.VertexFormat.Attribute;
import nephele.engine.render.gl.shader.TextureUnit;
import nephele.engine.render.gl.shader.Uniforms;
import org.lwjgl.system.MemoryUtil;

/**
 * Draws a canvas over a finished picture with one call. No level requires it: the program that shows an overlay creates
 * it. Program, texture and buffers are created when the first non-empty canvas is drawn.
 */
public final class OverlayPass implements AutoCloseable {
    private static final String FOLDER = "/nephele/engine/render/pass/overlay/";
    private static final VertexFormat FORMAT = VertexFormat.of(Attribute.FLOAT4, Attribute.FLOAT4);

    private final GlContext gl;
    private final FontAtlas atlas;
    private GlProgram<Uniforms.Vector4> program;
    private Texture letters;
    private Texture pictureTexture;
    private Picture uploadedPicture;
    private QuadStream quads;
    private OverlayCanvas uploaded;
    private long uploadedVersion;

    /** Creates the pass; its OpenGL objects follow with the first draw. */
    public OverlayPass(GlContext gl, FontAtlas atlas) {
        this.gl = gl;
        this.atlas = atlas;
    }

    /** Draws nothing for an empty canvas. */
    public void draw(OverlayCanvas canvas, RenderTarget picture) {
        if (canvas.isEmpty()) {
            return;
        }
        if (program == null) {
            build();
        }
        if (canvas != uploaded || canvas.version() != uploadedVersion) {
            upload(canvas.picture());
            quads.upload(canvas.vertices(), canvas.length(), canvas.quads());
            uploaded = canvas;
            uploadedVersion = canvas.version();
        }
        picture.bind();
        gl.state().set(Depth.OFF, Blend.OVER, Cull.NONE);
        letters.bind(TextureUnit.COLOURS);
        (pictureTexture == null ? letters : pictureTexture).bind(TextureUnit.OVERLAY_PICTURE);
        program.use();
        program.uniforms().set(picture.width(), picture.height(), 0, 0);
        quads.draw();
    }

    /** Keeps the texture while the picture stays the same, also while none is drawn. */
    private void upload(Picture picture) {
        if (picture == null || picture == uploadedPicture) {
            return;
        }
        if (pictureTexture != null) {
            pictureTexture.close();
        }
        uploadedPicture = picture;
        pictureTexture = texture(
                "overlay picture",
                PixelFormat.RGBA8,
                Texture.Extent.flat(picture.width(), picture.height()),
                picture.toRgba8().samples());
    }

    /** Returns true if the resources exist. */
    boolean isBuilt() {
        return program != null;
    }

    private void build() {
        var defines = Map.of(
                "ATLAS_WIDTH", FontAtlas.WIDTH_TEXELS + ".0",
                "ATLAS_HEIGHT", atlas.height() + ".0",
                "STEPS_PER_TEXEL", FontAtlas.STEPS_PER_TEXEL + ".0");
        program = GlProgram.of(
                gl,
                FOLDER + "overlay.vert",
                FOLDER + "overlay.frag",
                defines,
                uniforms -> uniforms.vector4("pictureSize"));
        quads = new QuadStream(gl, "overlay", FORMAT);
        letters = texture(
                "letters", PixelFormat.R8, Texture.Extent.flat(FontAtlas.WIDTH_TEXELS, atlas.height()), atlas.texels());
    }

    private Texture texture(String name, PixelFormat format, Texture.Extent size, byte[] samples) {
        var texture = new Texture(gl, name, Texture.Shape.FLAT, format, size, Sampling.LINEAR_CLAMP);
        ByteBuffer texels = MemoryUtil.memAlloc(samples.length);
        texture.upload(0, texels.put(samples).flip());
        MemoryUtil.memFree(texels);
        return texture;
    }

    @Override
    public void close() {
        if (program != null) {
            letters.close();
            quads.close();
        }
        if (pictureTexture != null) {
            pictureTexture.close();
        }
    }
}
