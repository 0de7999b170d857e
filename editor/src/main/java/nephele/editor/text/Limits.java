package nephele.editor.text;

import java.util.Collections;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Stream;
import nephele.editor.record.RecordField;
import nephele.editor.record.RecordKind;
import nephele.engine.asset.AssetId;
import nephele.engine.level.Exposure;
import nephele.engine.level.NumberRange;
import nephele.engine.level.TextKind;
import nephele.engine.level.json.NumberText;
import nephele.engine.math.Vec3;

/** What the declarations of a level's records let a file hold, and the words for what it cannot. */
public final class Limits {
    private static final Words RANGE =
            Words.of("%s must be from %s to %s %s", "%s deve ficar de %s a %s %s", "%s tem de ficar de %s a %s %s");
    private static final Words RANGES =
            Words.of("%s must be %s or %s %s", "%s deve ser %s ou %s %s", "%s tem de ser %s ou %s %s");
    private static final Words NO_DIRECTION = Words.of(
            "%s has no length: give a direction that points somewhere",
            "%s não tem comprimento: dê uma direção que aponte para algum lado",
            "%s não tem comprimento: dá uma direção que aponte para algum lado");
    private static final Words LENGTH = Words.of(
            "%s must have %s to %s characters",
            "%s deve ter de %s a %s caracteres", "%s tem de ter de %s a %s caracteres");
    private static final Words TOO_MANY =
            Words.of("%s has at most %s entries", "%s tem no máximo %s entradas", "%s tem no máximo %s entradas");
    private static final Words NO_FILE_NAME = Words.of(
            "\"%s\" names no file; write a path of letters, digits, '.', '_', '-' and '/'",
            "\"%s\" não é nome de arquivo; escreva um caminho com letras, dígitos, '.', '_', '-' e '/'",
            "\"%s\" não é nome de ficheiro; escreve um caminho com letras, dígitos, '.', '_', '-' e '/'");

    private Limits() {}

    /** Returns what is wrong with a value of a component or with an entry of it, and what would be right. */
    public static Optional<Words> problem(RecordField field, Object value) {
        boolean isAbsent =
                !field.isRequired() && Objects.equals(value, field.written().absent());
        if (isAbsent) {
            return Optional.empty();
        } else if (value instanceof Number number) {
            return number(field, number.doubleValue());
        } else if (value instanceof Exposure exposure) {
            return exposure.isAuto() ? Optional.empty() : number(field, exposure.fixedStops());
        } else if (value instanceof Vec3 vector) {
            return vector(field, vector);
        } else if (value instanceof String text) {
            return text(field, text);
        } else if (value instanceof List<?> list
                && list.size() > field.declaration().most()) {
            return Optional.of(tooMany(field, field.declaration().most()));
        }
        return Optional.empty();
    }

    private static Optional<Words> number(RecordField field, double number) {
        return field.range().contains(number) ? Optional.empty() : Optional.of(range(field));
    }

    private static Optional<Words> vector(RecordField field, Vec3 vector) {
        boolean isWithin = Stream.of(vector.x(), vector.y(), vector.z()).allMatch(field.range()::contains);
        if (!isWithin) {
            return Optional.of(range(field));
        }
        return field.range().reaches(vector) ? Optional.empty() : Optional.of(NO_DIRECTION.with(FieldWords.of(field)));
    }

    private static Words range(RecordField field) {
        NumberRange range = field.range();
        String[] parts = range.text("%s … %s", "|", NumberText::of).split("\\|");
        return parts.length > 1
                ? RANGES.with(FieldWords.of(field), parts[0], parts[1], field.unit())
                : RANGE.with(
                        FieldWords.of(field), NumberText.of(range.min()), NumberText.of(range.max()), field.unit());
    }

    private static Optional<Words> text(RecordField field, String text) {
        TextKind kind = field.declaration().text();
        if (text.length() < kind.shortest() || text.length() > kind.longest()) {
            return Optional.of(length(FieldWords.of(field), kind));
        }
        return kind != TextKind.ASSET || AssetId.rejectionReason(text) == null
                ? Optional.empty()
                : Optional.of(NO_FILE_NAME.with(text));
    }

    /** Returns the words for a list that is full. */
    public static Words tooMany(RecordField list, int most) {
        return TOO_MANY.with(FieldWords.of(list), most);
    }

    /** Returns the words for a text that is too short or too long. */
    public static Words length(Object name, TextKind kind) {
        return LENGTH.with(name, kind.shortest(), kind.longest());
    }

    /**
     * Returns the first thing that a file could not hold of a record, of what differs from an earlier state of it.
     *
     * @param before {@code null} for a new record
     */
    public static Optional<Words> change(Record before, Record after) {
        RecordKind kind = RecordKind.of(after);
        Record same = before != null && before.getClass() == after.getClass() ? before : null;
        for (RecordField field : kind.fields()) {
            Object old = same == null ? null : kind.get(same, field);
            Optional<Words> problem = value(field, old, kind.get(after, field));
            if (problem.isPresent()) {
                return problem;
            }
        }
        return Optional.empty();
    }

    private static Optional<Words> value(RecordField field, Object before, Object after) {
        if (after == before && after != null) {
            return Optional.empty();
        } else if (after instanceof List<?> list) {
            List<?> old = before instanceof List<?> earlier ? earlier : List.of();
            return problem(field, list).or(() -> entries(field, old, list));
        } else if (after instanceof Map<?, ?> table) {
            Map<?, ?> old = before instanceof Map<?, ?> earlier ? earlier : Map.of();
            return entries(field, List.copyOf(old.values()), List.copyOf(table.values()));
        }
        return after instanceof Record nested && !field.recordClasses().isEmpty()
                ? change(before instanceof Record old ? old : null, nested)
                : problem(field, after);
    }

    private static Optional<Words> entries(RecordField field, List<?> before, List<?> after) {
        Set<Object> known = null;
        for (int i = 0; i < after.size(); i++) {
            Object entry = after.get(i);
            if (i < before.size() && entry == before.get(i)) {
                continue;
            }
            if (known == null) {
                known = Collections.newSetFromMap(new IdentityHashMap<>());
                known.addAll(before);
            }
            Optional<Words> problem = known.contains(entry) ? Optional.empty() : value(field, null, entry);
            if (problem.isPresent()) {
                return problem;
            }
        }
        return Optional.empty();
    }
}
