package nephele.engine.render.pass.particle;

import java.nio.FloatBuffer;
import nephele.engine.render.gl.GlContext;
import nephele.engine.render.gl.GlObject;
import nephele.engine.render.gl.shader.TextureUnit;
import nephele.engine.render.resource.SquareSheet;

/** The squares of a view's particles, drawn with one call. */
final class ParticleQuads implements GlObject {
    static final int PER_SHEET = 512;
    /** Three texels for each particle, see {@code particle.vert}. */
    static final int FLOATS = 12;

    private final SquareSheet squares;
    private int count;

    ParticleQuads(GlContext gl) {
        squares = new SquareSheet(gl, "particles", PER_SHEET, FLOATS, 1);
    }

    /**
     * Begins the list of a view.
     *
     * @return where the {@link #FLOATS} numbers of each particle go, the farthest first
     */
    FloatBuffer begin(int particles) {
        count = particles;
        return squares.staging(particles).clear();
    }

    /** Draws the list with the current program, which reads the texels from unit {@code DYNAMIC_INSTANCES}. */
    void draw() {
        squares.draw(count, 0, TextureUnit.DYNAMIC_INSTANCES);
    }

    @Override
    public void close() {
        squares.close();
    }
}
