package nephele.engine.render.resource;

import java.util.ArrayList;
import java.util.List;
import nephele.engine.render.frame.LoadContext;
import nephele.engine.render.frame.SharedResource;
import nephele.engine.render.gl.GlContext;
import nephele.engine.render.gl.GlObject;
import nephele.engine.render.gl.GpuMesh;
import nephele.engine.render.gl.IndexRanges;
import nephele.engine.render.gl.SharedObjects.Identity;
import nephele.engine.render.gl.VertexFormat;
import nephele.engine.render.gl.VertexFormat.Attribute;
import nephele.engine.scene.SolidBatch;
import nephele.engine.scene.SolidGeometry;
import nephele.engine.scene.VisibleSet;

/**
 * {@link SolidGeometry} on the GPU; shader locations 0 position, 1 normal and material, 2 texture coordinates, 3 light
 * map or, for models, smooth normal and sky visibility.
 */
public final class SolidMesh implements GlObject {
    public static final SharedResource<SolidMesh> RESOURCE = SharedResource.of("solids", SolidMesh::of);

    private static final VertexFormat FORMAT = VertexFormat.of(Attribute.FLOAT3, Attribute.INT16X4, Attribute.FLOAT2);
    private static final VertexFormat LIGHT_MAPPED =
            VertexFormat.of(Attribute.FLOAT3, Attribute.INT16X4, Attribute.FLOAT2, Attribute.INT16X2);

    private static final VertexFormat OF_MODELS =
            VertexFormat.of(Attribute.FLOAT3, Attribute.INT16X4, Attribute.FLOAT2, Attribute.INT16X4);

    private final SolidGeometry geometry;
    private final GpuMesh solids;
    private final GpuMesh models;
    private final List<IndexRanges> ranges = new ArrayList<>();

    public SolidMesh(GlContext gl, SolidGeometry geometry) {
        this.geometry = geometry;
        VertexFormat format = geometry.lightMapped() ? LIGHT_MAPPED : FORMAT;
        solids = mesh(gl, "solids", format, geometry.solids());
        models = mesh(gl, "models", OF_MODELS, geometry.models());
        int mostRanges = geometry.slotCount();
        geometry.batches().forEach(batch -> ranges.add(new IndexRanges(mostRanges)));
    }

    private static SolidMesh of(LoadContext context) {
        SolidGeometry solids = context.scene().solids();
        return context.share(SolidMesh.class, new Identity(solids), () -> new SolidMesh(context.gl(), solids));
    }

    /** Returns {@code null} for no triangles. */
    private static GpuMesh mesh(GlContext gl, String name, VertexFormat format, SolidGeometry.Triangles triangles) {
        return triangles.isEmpty() ? null : new GpuMesh(gl, name, format, triangles.vertices(), triangles.indices());
    }

    public List<SolidBatch> batches() {
        return geometry.batches();
    }

    /** Draws the visible ranges of one batch with the current program and uniforms. */
    public void draw(int batch, VisibleSet visible) {
        IndexRanges batchRanges = ranges.get(batch);
        batchRanges.set(visible.firsts(batch), visible.lengths(batch), visible.size(batch));
        (batches().get(batch).form().isModel() ? models : solids).draw(batchRanges);
    }

    @Override
    public void close() {
        if (solids != null) {
            solids.close();
        }
        if (models != null) {
            models.close();
        }
        ranges.forEach(IndexRanges::close);
    }
}
