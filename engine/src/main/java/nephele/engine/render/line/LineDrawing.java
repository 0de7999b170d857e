package nephele.engine.render.line;

import java.util.Map;
import nephele.engine.render.gl.DrawState.Blend;
import nephele.engine.render.gl.DrawState.Cull;
import nephele.engine.render.gl.DrawState.Depth;
import nephele.engine.render.gl.GlContext;
import nephele.engine.render.gl.GlProgram;
import nephele.engine.render.gl.PolygonStream;
import nephele.engine.render.gl.RenderTarget;
import nephele.engine.render.gl.VertexFormat;
import nephele.engine.render.gl.VertexFormat.Attribute;

/** Draws canvases of lines. */
public final class LineDrawing implements AutoCloseable {
    static final String FOLDER = "/nephele/engine/render/line/";
    private static final VertexFormat FORMAT = VertexFormat.of(Attribute.FLOAT3, Attribute.FLOAT4, Attribute.FLOAT2);

    private final GlContext gl;
    private final PolygonStream triangles;
    private final GlProgram<?> program;

    /** Creates the program and a buffer. */
    public LineDrawing(GlContext gl) {
        this.gl = gl;
        triangles = new PolygonStream(gl, "lines", FORMAT);
        program = GlProgram.of(gl, FOLDER + "line.vert", FOLDER + "line.frag", Map.of());
    }

    /** Draws over a picture, whose depth hides what is behind its surfaces. */
    public void draw(LineCanvas canvas, RenderTarget picture) {
        picture.bind();
        draw(canvas, LineLayer.BEHIND_SURFACES, Depth.LESS_OR_EQUAL);
        draw(canvas, LineLayer.OVER_ALL, Depth.OFF);
    }

    private void draw(LineCanvas canvas, LineLayer layer, Depth depth) {
        LineCanvas.Vertices vertices = canvas.vertices(layer);
        if (vertices.length() > 0) {
            gl.state().set(depth, Blend.OVER, Cull.NONE);
            program.use();
            triangles.upload(vertices.floats(), vertices.length());
            triangles.draw(0, vertices.length() / LineCanvas.FLOATS_PER_VERTEX);
        }
    }

    @Override
    public void close() {
        triangles.close();
    }
}
