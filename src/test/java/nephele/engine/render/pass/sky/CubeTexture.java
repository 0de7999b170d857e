package nephele.engine.render.pass.sky;

import static org.lwjgl.opengl.GL41C.*;

import java.nio.ByteBuffer;
import java.util.List;
import nephele.engine.asset.AssetSource;
import nephele.engine.asset.Picture;
import nephele.engine.asset.PictureDecoder;
import nephele.engine.math.Vec3;
import nephele.engine.scene.View;
import org.lwjgl.BufferUtils;

/** Six files in a cube texture of OpenGL, each as it is, sampled by the directions of a view in the world. */
final class CubeTexture implements AutoCloseable {
    private static final String VERTEX =
            """
            #version 410 core
            uniform vec3 right, up, ahead;
            out vec3 direction;
            void main() {
                vec2 at = vec2(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0);
                direction = ahead + at.x * right + at.y * up;
                gl_Position = vec4(at, 0.0, 1.0);
            }
            """;

    private static final String FRAGMENT =
            """
            #version 410 core
            uniform samplerCube faces;
            in vec3 direction;
            out vec4 colour;
            void main() {
                colour = texture(faces, direction);
            }
            """;

    private final int texture = glGenTextures();
    private final int vertexArray = glGenVertexArrays();
    private final int program = glCreateProgram();

    CubeTexture(List<String> files, AssetSource assets) {
        glActiveTexture(GL_TEXTURE0);
        glBindTexture(GL_TEXTURE_CUBE_MAP, texture);
        for (int face = 0; face < 6; face++) {
            String file = files.get(face);
            Picture picture = PictureDecoder.decode(file, assets.bytes(file)).toRgba8();
            ByteBuffer texels = BufferUtils.createByteBuffer(picture.samples().length)
                    .put(picture.samples())
                    .flip();
            int target = GL_TEXTURE_CUBE_MAP_POSITIVE_X + face;
            int side = picture.width();
            glTexImage2D(target, 0, GL_RGBA8, side, side, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels);
        }
        glTexParameteri(GL_TEXTURE_CUBE_MAP, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
        glTexParameteri(GL_TEXTURE_CUBE_MAP, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
        attach(GL_VERTEX_SHADER, VERTEX);
        attach(GL_FRAGMENT_SHADER, FRAGMENT);
        glLinkProgram(program);
    }

    private void attach(int kind, String source) {
        int shader = glCreateShader(kind);
        glShaderSource(shader, source);
        glCompileShader(shader);
        glAttachShader(program, shader);
        glDeleteShader(shader);
    }

    /** Fills the bound target as a view with a field of view of 90° both ways sees it. */
    void draw(View view) {
        glEnable(GL_TEXTURE_CUBE_MAP_SEAMLESS);
        glDisable(GL_DEPTH_TEST);
        glUseProgram(program);
        set("right", view.right());
        set("up", view.up());
        set("ahead", view.back().negated());
        glBindVertexArray(vertexArray);
        glDrawArrays(GL_TRIANGLES, 0, 3);
    }

    private void set(String name, Vec3 value) {
        glUniform3f(glGetUniformLocation(program, name), (float) value.x(), (float) value.y(), (float) value.z());
    }

    @Override
    public void close() {
        glDeleteProgram(program);
        glDeleteVertexArrays(vertexArray);
        glDeleteTextures(texture);
    }
}
