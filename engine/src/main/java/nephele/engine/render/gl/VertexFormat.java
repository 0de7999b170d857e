package nephele.engine.render.gl;

import static org.lwjgl.opengl.GL41C.*;

import java.util.List;

/** The layout of a vertex in its buffer: attribute i of the list is shader location i. */
public record VertexFormat(List<Attribute> attributes) {
    /** The components of one attribute in memory; each fills a multiple of four bytes. */
    public enum Attribute {
        FLOAT2(2, GL_FLOAT, 8),
        FLOAT3(3, GL_FLOAT, 12),
        FLOAT4(4, GL_FLOAT, 16),
        /**
         * Four signed 16-bit integers, read as floats of the same value: before OpenGL 4.2, normalised ones have no
         * zero.
         */
        INT16X4(4, GL_SHORT, 8),
        /** Two signed 16-bit integers, read as floats of the same value. */
        INT16X2(2, GL_SHORT, 4),
        /** Four bytes, read as 0…1. */
        UNORM8X4(4, GL_UNSIGNED_BYTE, 4),
        /** Two unsigned 16-bit integers, read as integers. */
        UINT16X2(2, GL_UNSIGNED_SHORT, 4);

        private final int components;
        private final int type;
        private final int bytes;

        Attribute(int components, int type, int bytes) {
            this.components = components;
            this.type = type;
            this.bytes = bytes;
        }

        public int bytes() {
            return bytes;
        }
    }

    public static VertexFormat of(Attribute... attributes) {
        return new VertexFormat(List.of(attributes));
    }

    public int strideBytes() {
        return attributes.stream().mapToInt(Attribute::bytes).sum();
    }

    /** Describes the bound array buffer to the bound vertex array. */
    void describe() {
        int stride = strideBytes();
        long offset = 0;
        for (int i = 0; i < attributes.size(); i++) {
            Attribute a = attributes.get(i);
            glEnableVertexAttribArray(i);
            if (a == Attribute.UINT16X2) {
                glVertexAttribIPointer(i, a.components, a.type, stride, offset);
            } else {
                glVertexAttribPointer(i, a.components, a.type, a.type == GL_UNSIGNED_BYTE, stride, offset);
            }
            offset += a.bytes();
        }
    }
}
