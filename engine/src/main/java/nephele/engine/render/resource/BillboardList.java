package nephele.engine.render.resource;

import java.util.List;
import nephele.engine.render.gl.GlContext;
import nephele.engine.render.gl.GlObject;
import nephele.engine.render.gl.shader.TextureUnit;
import nephele.engine.render.resource.BillboardQuads.Cluster;

/** The images of billboards that are drawn, in their order. */
public final class BillboardList implements GlObject {
    /** Images of one cell in an instance; a multiple of the four that a texel names, as is a sixteenth of it. */
    public static final int PER_SHEET = 256;

    private static final int FINE_CELLS = 4;

    private static final int NONE = -1;

    private final SquareSheet squares;
    private final int perSheet;
    private final int vertices;
    private int count;

    /** @param cells along a side of each image */
    public BillboardList(GlContext gl, int cells) {
        perSheet = cells < FINE_CELLS ? PER_SHEET : PER_SHEET / 16;
        vertices = SquareSheet.vertices(cells);
        squares = new SquareSheet(gl, "billboards", perSheet, 1, cells);
    }

    /** Returns the number of images of an instance. */
    public int perSheet() {
        return perSheet;
    }

    /** Returns the number of vertices of an image. */
    public int vertices() {
        return vertices;
    }

    /** Begins a list. */
    public void begin() {
        count = 0;
    }

    /** Adds an image by its number in {@link BillboardQuads}. */
    public void add(int image) {
        squares.staging(count + 1).put(count, image);
        count++;
    }

    public int count() {
        return count;
    }

    /** Draws clusters that are ordered by arrays of pictures. */
    public void draw(List<Cluster> clusters, BillboardQuads quads) {
        begin();
        for (int i = 0; i < clusters.size(); i++) {
            Cluster cluster = clusters.get(i);
            for (int image = cluster.first(); image < cluster.end(); image++) {
                add(image);
            }
            if (i + 1 == clusters.size() || clusters.get(i + 1).array() != cluster.array()) {
                quads.bindSprites(cluster.array());
                draw();
                begin();
            }
        }
    }

    /** Draws the list with the current program. */
    public void draw() {
        if (count > 0) {
            squares.draw(count, NONE, TextureUnit.BILLBOARD_ORDER);
        }
    }

    @Override
    public void close() {
        squares.close();
    }
}
