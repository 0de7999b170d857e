package nephele.engine.asset;

import java.io.ByteArrayOutputStream;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import nephele.engine.asset.PictureFormat.Span;

/**
 * The marker segments of a JPEG file up to its frame header (ITU-T T.81, B.1.1.4 and B.2.2).
 *
 * @param frame second byte of the frame's marker, which tells the kind of compression
 * @param adobeTransform how the components are coded by Adobe's segment: 0 as they are, 1 YCbCr, 2 YCCK; -1 without it
 * @param profiles the segments with parts of an ICC profile, from their markers on
 */
record JpegHeader(
        ByteBuffer file,
        int frame,
        int bits,
        int width,
        int height,
        int components,
        int adobeTransform,
        List<Span> profiles) {
    private static final int ADOBE = 0xee;
    private static final int APP_2 = 0xe2;
    private static final String PROFILE = "ICC_PROFILE\0";
    private static final int PROFILE_HEAD = PROFILE.length() + 2;
    private static final int ARITHMETIC = 0xc8;

    /** Returns {@code null} if the file ends before the frame header, or has none. */
    static JpegHeader of(byte[] bytes) {
        ByteBuffer file = ByteBuffer.wrap(bytes);
        List<Span> profiles = new ArrayList<>();
        int adobe = -1;
        int at = 2;
        while (at + 10 <= file.limit()) {
            int marker = file.getShort(at) & 0xffff;
            if (marker >>> 8 != 0xff) {
                return null;
            }
            int kind = marker & 0xff;
            if (kind >= 0xc0 && kind <= 0xcf && kind != 0xc4 && kind != 0xc8 && kind != 0xcc) {
                int height = file.getShort(at + 5) & 0xffff;
                int width = file.getShort(at + 7) & 0xffff;
                return new JpegHeader(
                        file, kind, file.get(at + 4) & 0xff, width, height, file.get(at + 9) & 0xff, adobe, profiles);
            }
            int length = file.getShort(at + 2) & 0xffff;
            if (kind == ADOBE && begins(bytes, at + 4, "Adobe") && length >= 14 && at + 16 <= file.limit()) {
                adobe = file.get(at + 15) & 0xff;
            } else if (kind == APP_2 && begins(bytes, at + 4, PROFILE)) {
                profiles.add(new Span(at, length + 2));
            }
            at += marker == 0xffff ? 1 : 2 + length;
        }
        return null;
    }

    private static boolean begins(byte[] bytes, int at, String text) {
        int end = Math.min(bytes.length, at + text.length());
        return new String(bytes, at, end - at, StandardCharsets.ISO_8859_1).equals(text);
    }

    /** Returns why files of this kind are not read; {@code null} if they are. */
    String objection() {
        if (frame > ARITHMETIC) {
            return "is a JPEG with arithmetic coding";
        }
        if (frame > 0xc2) {
            return "is a " + (frame == 0xc3 ? "lossless" : "hierarchical") + " JPEG";
        }
        if (bits != 8) {
            return "is a JPEG of " + bits + " bits";
        }
        if (components == 4 && adobeTransform < 0) {
            return "is a JPEG of four components that does not say which colours they are";
        }
        return components == 1 || components == 3 || components == 4
                ? null
                : "is a JPEG of " + components + " components";
    }

    /** Returns the embedded profile, {@code null} without one; its parts follow each other in the file. */
    byte[] profile() {
        ByteArrayOutputStream whole = new ByteArrayOutputStream();
        for (Span part : profiles) {
            int from = part.offset() + 4 + PROFILE_HEAD;
            whole.write(file.array(), from, Math.max(0, Math.min(part.offset() + part.length(), file.limit()) - from));
        }
        return whole.size() == 0 ? null : whole.toByteArray();
    }

    /** Returns the file without its profile, whose colours a reader then leaves as they are. */
    byte[] withoutProfile() {
        ByteArrayOutputStream rest = new ByteArrayOutputStream(file.limit());
        int at = 0;
        for (Span part : profiles) {
            rest.write(file.array(), at, part.offset() - at);
            at = Math.min(part.offset() + part.length(), file.limit());
        }
        rest.write(file.array(), at, file.limit() - at);
        return rest.toByteArray();
    }
}
