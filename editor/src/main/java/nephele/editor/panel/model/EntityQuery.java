package nephele.editor.panel.model;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.OptionalDouble;
import java.util.Set;
import java.util.TreeSet;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import nephele.editor.record.Entities;
import nephele.editor.record.EntityRef;
import nephele.editor.record.EntitySection;
import nephele.editor.record.RecordField;
import nephele.editor.record.RecordKind;
import nephele.editor.record.SingleSection;
import nephele.editor.text.Words;
import nephele.engine.level.Exposure;
import nephele.engine.math.Vec3;

/**
 * A search for entities, such as {@code material:brick portalable:true size>4}. All terms must match: a plain word is a
 * part of the id; {@code type:}, {@code hidden:} and {@code locked:} ask for the entity; any other word before
 * {@code : = > < >= <=} names a component, also of a nested record. A vector counts with its greatest component.
 *
 * @param errors what is wrong with the text, for the user; terms with an error are left out
 */
public record EntityQuery(List<Term> terms, List<Words> errors) {
    /** The query that everything matches. */
    public static final EntityQuery ALL = new EntityQuery(List.of(), List.of());

    private static final Pattern WORD = Pattern.compile("[^\\s\"]*\"[^\"]*\"|\\S+");
    private static final Pattern TERM = Pattern.compile("([A-Za-z]\\w*)(>=|<=|[:=<>])(.*)");
    private static final Set<String> FLAGS = Set.of("hidden", "locked");

    public EntityQuery {
        terms = List.copyOf(terms);
        errors = List.copyOf(errors);
    }

    /** Returns the query of a text. */
    public static EntityQuery parse(String text, Entities entities) {
        List<Term> terms = new ArrayList<>();
        List<Words> errors = new ArrayList<>();
        Matcher words = WORD.matcher(text);
        while (words.find()) {
            String word = words.group().replace("\"", "");
            Matcher term = TERM.matcher(word);
            if (!term.matches()) {
                terms.add(new Term("", ":", word.toLowerCase(Locale.ROOT)));
                continue;
            }
            var parsed = new Term(term.group(1), term.group(2), term.group(3).toLowerCase(Locale.ROOT));
            Words error = error(parsed, entities);
            if (error == null) {
                terms.add(parsed);
            } else {
                errors.add(error);
            }
        }
        return new EntityQuery(terms, errors);
    }

    private static Words error(Term term, Entities entities) {
        if (term.value().isEmpty()) {
            return PanelText.QUERY_NO_VALUE.with(term.name() + term.operator());
        }
        if (term.isComparison() && term.number().isEmpty()) {
            return PanelText.QUERY_NO_NUMBER.with(term.name() + term.operator(), term.value());
        }
        if (FLAGS.contains(term.name()) && !term.value().matches("true|false")) {
            return PanelText.QUERY_NO_TRUTH.with(term.name());
        }
        boolean isKnown = FLAGS.contains(term.name()) || term.name().equals("type");
        return isKnown || componentNames(entities).contains(term.name())
                ? null
                : PanelText.QUERY_NO_COMPONENT.with(term.name());
    }

    /** Returns the names of all components that entities have, for completion. */
    public static Set<String> componentNames(Entities entities) {
        Set<String> names = new TreeSet<>();
        Set<Class<?>> visited = new java.util.HashSet<>();
        for (EntitySection section : entities.lists()) {
            section.kinds().forEach(kind -> collect(kind, names, visited));
        }
        for (SingleSection single : entities.singles()) {
            if (!single.path().isEmpty()) {
                single.kinds().forEach(kind -> collect(kind, names, visited));
            }
        }
        return names;
    }

    private static void collect(RecordKind kind, Set<String> names, Set<Class<?>> visited) {
        if (!visited.add(kind.type())) {
            return;
        }
        for (RecordField field : kind.fields()) {
            names.add(field.name());
            field.recordClasses().forEach(type -> collect(RecordKind.of(type), names, visited));
        }
    }

    /** Returns true if an entity matches all terms. */
    public boolean matches(EntityRef ref, Record entity, EntityStatus status) {
        return terms.stream().allMatch(term -> term.matches(ref, entity, status));
    }

    /**
     * A condition of a query.
     *
     * @param name of a component, {@code type}, {@code hidden} or {@code locked}; empty for a part of the id
     * @param operator {@code : = < > <= >=}
     * @param value in lower case
     */
    public record Term(String name, String operator, String value) {
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
}
