package nephele.editor.save.journal;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.DataInputStream;
import java.io.DataOutputStream;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.time.DateTimeException;
import java.time.Instant;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.zip.CRC32C;
import java.util.zip.DeflaterOutputStream;
import java.util.zip.InflaterInputStream;
import nephele.editor.save.DocumentFile;

/**
 * Converts records of a journal to bytes and back. A log is a head and records; each record has its length and its
 * CRC-32C before it, so that a torn or damaged end is recognised and ignored.
 */
final class JournalFormat {
    /** The first bytes of a log, with the version of the format. */
    private static final byte[] HEAD = "nephele-journal 1\n".getBytes(StandardCharsets.US_ASCII);

    private static final int FRAME_BYTES = 8;
    private static final int MOST_TEXT_BYTES = 64 << 20;
    private static final byte BASE = 0;
    private static final byte EDIT = 1;

    private JournalFormat() {}

    /** Returns a log that starts with a record. */
    static byte[] log(JournalRecord.Base base, JournalRecord.Edit edit) {
        var log = new ByteArrayOutputStream();
        log.writeBytes(HEAD);
        log.writeBytes(framed(base));
        log.writeBytes(framed(edit));
        return log.toByteArray();
    }

    /** Returns a record with its length and checksum. */
    static byte[] framed(JournalRecord record) {
        byte[] payload = payload(record);
        return ByteBuffer.allocate(FRAME_BYTES + payload.length)
                .putInt(payload.length)
                .putInt(checksum(payload, 0, payload.length))
                .put(payload)
                .array();
    }

    /** Returns the records of a log up to the first torn or damaged one. */
    static List<JournalRecord> records(byte[] log) {
        List<JournalRecord> records = new ArrayList<>();
        if (log.length < HEAD.length || !Arrays.equals(log, 0, HEAD.length, HEAD, 0, HEAD.length)) {
            return records;
        }
        ByteBuffer bytes = ByteBuffer.wrap(log).position(HEAD.length);
        while (bytes.remaining() >= FRAME_BYTES) {
            int length = bytes.getInt();
            int checksum = bytes.getInt();
            if (length <= 0 || length > bytes.remaining() || checksum != checksum(log, bytes.position(), length)) {
                return records;
            }
            Optional<JournalRecord> record = record(new ByteArrayInputStream(log, bytes.position(), length));
            if (record.isEmpty()) {
                return records;
            }
            records.add(record.get());
            bytes.position(bytes.position() + length);
        }
        return records;
    }

    private static int checksum(byte[] bytes, int from, int length) {
        var checksum = new CRC32C();
        checksum.update(bytes, from, length);
        return (int) checksum.getValue();
    }

    private static byte[] payload(JournalRecord record) {
        var bytes = new ByteArrayOutputStream();
        try (var out = new DataOutputStream(bytes)) {
            if (record instanceof JournalRecord.Base base) {
                out.writeByte(BASE);
                out.writeLong(base.time().toEpochMilli());
                text(out, base.title());
                text(out, base.file().path().map(Path::toString).orElse(""));
                text(out, base.file().sha256());
                deflated(out, base.text());
            } else if (record instanceof JournalRecord.Edit edit) {
                out.writeByte(EDIT);
                out.writeLong(edit.time().toEpochMilli());
                out.writeLong(edit.number());
                text(out, edit.label());
                out.writeInt(edit.prefix());
                out.writeInt(edit.suffix());
                deflated(out, edit.middle());
            }
        } catch (IOException impossible) {
            throw new UncheckedIOException(impossible);
        }
        return bytes.toByteArray();
    }

    private static Optional<JournalRecord> record(ByteArrayInputStream payload) {
        try (var in = new DataInputStream(payload)) {
            byte kind = in.readByte();
            Instant time = Instant.ofEpochMilli(in.readLong());
            return switch (kind) {
                case BASE -> Optional.of(new JournalRecord.Base(time, text(in), file(in), inflated(in)));
                case EDIT ->
                    Optional.of(new JournalRecord.Edit(
                            time, in.readLong(), text(in), in.readInt(), in.readInt(), inflated(in)));
                default -> Optional.empty();
            };
        } catch (IOException | DateTimeException | InvalidPathException damaged) {
            return Optional.empty();
        }
    }

    private static DocumentFile file(DataInputStream in) throws IOException {
        String path = text(in);
        String sha256 = text(in);
        return new DocumentFile(path.isEmpty() ? Optional.empty() : Optional.of(Path.of(path)), sha256);
    }

    private static void text(DataOutputStream out, String text) throws IOException {
        byte[] utf8 = text.getBytes(StandardCharsets.UTF_8);
        out.writeInt(utf8.length);
        out.write(utf8);
    }

    private static String text(DataInputStream in) throws IOException {
        return new String(exactly(in, in.readInt()), StandardCharsets.UTF_8);
    }

    private static byte[] exactly(DataInputStream in, int length) throws IOException {
        if (length < 0 || length > in.available()) {
            throw new IOException("a length is wrong");
        }
        return in.readNBytes(length);
    }

    private static void deflated(DataOutputStream out, byte[] content) throws IOException {
        out.writeInt(content.length);
        try (var deflater = new DeflaterOutputStream(out)) {
            deflater.write(content);
        }
    }

    private static byte[] inflated(DataInputStream in) throws IOException {
        int length = in.readInt();
        if (length < 0 || length > MOST_TEXT_BYTES) {
            throw new IOException("a length is wrong");
        }
        byte[] content = new InflaterInputStream(in).readNBytes(length);
        if (content.length != length) {
            throw new IOException("a text is too short");
        }
        return content;
    }
}
