package nephele.engine.model.file;

import nephele.engine.model.file.GltfAccessors.Use;

/**
 * A primitive of triangles (glTF 2.0, 3.7.2), validated; its numbers are not yet read.
 *
 * @param normals {@code null} without them
 * @param texture {@code null} without it
 * @param indices {@code null} if the vertices are used in their order
 */
record GltfPrimitive(
        int mode,
        GltfAccessor positions,
        GltfAccessor normals,
        GltfAccessor texture,
        GltfAccessor indices,
        TextureMap map) {
    static final int TRIANGLES = 4;
    static final int TRIANGLE_STRIP = 5;
    static final int TRIANGLE_FAN = 6;

    private static final String TRANSFORM = "KHR_texture_transform";

    /** The move and scale of texture coordinates, which a material adds by KHR_texture_transform. */
    record TextureMap(double s, double t, double scaleS, double scaleT) {
        static final TextureMap NONE = new TextureMap(0, 0, 1, 1);
    }

    static GltfPrimitive of(GltfValue root, GltfValue primitive, int mode, GltfAccessors accessors) {
        GltfValue attributes = primitive.member("attributes");
        if (!attributes.exists()) {
            throw attributes.error("is missing");
        }
        GltfAccessor positions = accessors.use(attributes.member("POSITION"), Use.POSITION);
        GltfAccessor normals = attribute(attributes, Use.NORMAL, positions, accessors);
        GltfAccessor texture = attribute(attributes, Use.TEXCOORD_0, positions, accessors);
        GltfValue listed = primitive.member("indices");
        GltfAccessor indices = listed.exists() ? accessors.use(listed, Use.INDICES) : null;
        int corners = (indices == null ? positions : indices).count();
        if (mode == TRIANGLES && corners % 3 != 0) {
            throw primitive.error("has " + corners + " corners, which is no multiple of three");
        }
        return new GltfPrimitive(mode, positions, normals, texture, indices, map(root, primitive));
    }

    private static GltfAccessor attribute(
            GltfValue attributes, Use use, GltfAccessor positions, GltfAccessors accessors) {
        GltfValue index = attributes.member(use.name());
        if (!index.exists()) {
            return null;
        }
        GltfAccessor accessor = accessors.use(index, use);
        if (accessor.count() != positions.count()) {
            throw index.error("has " + accessor.count() + " elements for " + positions.count() + " positions");
        }
        return accessor;
    }

    private static TextureMap map(GltfValue root, GltfValue primitive) {
        GltfValue materials = root.member("materials");
        GltfValue index = primitive.member("material");
        if (!index.exists()) {
            return TextureMap.NONE;
        }
        GltfValue transform = materials
                .at(index.index(materials.size(), "materials"))
                .memberIfAny("pbrMetallicRoughness")
                .memberIfAny("baseColorTexture")
                .memberIfAny("extensions")
                .memberIfAny(TRANSFORM);
        if (!transform.exists()) {
            return TextureMap.NONE;
        }
        GltfValue rotation = transform.member("rotation");
        if (rotation.exists() && rotation.number() != 0) {
            throw rotation.error("turns a texture, which can't be read", "turn the texture coordinates instead");
        }
        GltfValue offset = transform.member("offset");
        GltfValue scale = transform.member("scale");
        return new TextureMap(
                offset.numberAt(0, 2, 0), offset.numberAt(1, 2, 0), scale.numberAt(0, 2, 1), scale.numberAt(1, 2, 1));
    }

    /** Returns the larger of the numbers of vertices and triangles, which bounds the work and the memory. */
    long cost() {
        long corners = (indices == null ? positions : indices).count();
        return Math.max(positions.count(), mode == TRIANGLES ? corners / 3 : corners);
    }
}
