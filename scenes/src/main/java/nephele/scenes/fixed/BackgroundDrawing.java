package nephele.scenes.fixed;

import java.util.Map;
import nephele.engine.asset.Picture;
import nephele.engine.render.gl.DrawState.Blend;
import nephele.engine.render.gl.DrawState.Cull;
import nephele.engine.render.gl.DrawState.Depth;
import nephele.engine.render.gl.FullScreenTriangle;
import nephele.engine.render.gl.GlContext;
import nephele.engine.render.gl.GlProgram;
import nephele.engine.render.gl.Texture;
import nephele.engine.render.gl.shader.TextureUnit;

/** Draws a picture that fills the window behind the scene. */
final class BackgroundDrawing implements AutoCloseable {
    private final GlContext gl;
    private final Texture picture;
    private final FullScreenTriangle triangle;
    private final GlProgram<?> program;

    BackgroundDrawing(GlContext gl, Picture picture) {
        this.gl = gl;
        this.picture = PictureTexture.of(gl, "background", picture);
        triangle = new FullScreenTriangle(gl, "background");
        program = GlProgram.of(
                gl, FixedProgram.FOLDER + "background.vert", FixedProgram.FOLDER + "background.frag", Map.of());
    }

    void draw() {
        gl.state().set(Depth.OFF, Blend.REPLACE, Cull.NONE);
        picture.bind(TextureUnit.SCENE_PICTURE);
        program.use();
        triangle.draw();
    }

    @Override
    public void close() {
        picture.close();
        triangle.close();
    }
}
