package nephele.editor.panel.model;

import java.util.Locale;
import java.util.OptionalDouble;
import nephele.editor.record.EntityRef;
import nephele.editor.record.RecordKind;
import nephele.engine.level.Exposure;
import nephele.engine.math.Vec3;

/**
 * A condition of a query.
 *
 * @param name of a component, {@code type}, {@code hidden} or {@code locked}; empty for a part of the id
 * @param operator {@code : = < > <= >=}
 * @param value in lower case
 */
public record QueryTerm(String name, String operator, String value) {
    boolean isComparison() {
        return !operator.equals(":") && !operator.equals("=");
    }

    OptionalDouble number() {
        try {
            return OptionalDouble.of(Double.parseDouble(value));
        } catch (NumberFormatException text) {
            return OptionalDouble.empty();
        }
    }

    boolean matches(EntityRef ref, Record entity, EntityStatus status) {
        return switch (name) {
            case "" -> ref.text().toLowerCase(Locale.ROOT).contains(value);
            case "type" -> isOfType(ref, entity);
            case "hidden" -> status.isHidden(ref) == Boolean.parseBoolean(value);
            case "locked" -> status.isLocked(ref) == Boolean.parseBoolean(value);
            default -> hasValue(entity);
        };
    }

    private boolean isOfType(EntityRef ref, Record entity) {
        String section =
                ref.section().substring(ref.section().lastIndexOf('.') + 1).toLowerCase(Locale.ROOT);
        Class<?> type = entity.getClass();
        return RecordKind.of(entity).name().equals(value)
                || section.equals(value)
                || section.equals(value + "s")
                || (type.getDeclaringClass() != null
                        && type.getDeclaringClass().getSimpleName().equalsIgnoreCase(value));
    }

    private boolean hasValue(Record entity) {
        boolean[] found = {false};
        RecordKind.mapped(entity, (field, component) -> {
            found[0] |= component != null && field.name().equals(name) && isMet(component);
            return component;
        });
        return found[0];
    }

    private boolean isMet(Object component) {
        if (component instanceof Vec3 vector) {
            return isMet(Math.max(vector.x(), Math.max(vector.y(), vector.z())));
        } else if (component instanceof Number number) {
            return isMet(number.doubleValue());
        } else if (component instanceof Exposure exposure && !exposure.isAuto()) {
            return isMet(exposure.fixedStops());
        }
        String text = component.toString().toLowerCase(Locale.ROOT);
        return operator.equals(":") ? text.contains(value) : text.equals(value);
    }

    private boolean isMet(double component) {
        if (number().isEmpty()) {
            return false;
        }
        double limit = number().getAsDouble();
        return switch (operator) {
            case "<" -> component < limit;
            case ">" -> component > limit;
            case "<=" -> component <= limit;
            case ">=" -> component >= limit;
            default -> component == limit;
        };
    }
}
