package nephele.engine.model.shape;

import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.StringJoiner;
import java.util.function.Function;
import java.util.stream.Stream;

/** The shapes that are defined by numbers alone, by name. */
public enum ShapeKind {
    PLANE(n -> new PlaneShape(n[0], (int) n[1], false), ShapeParameter.LENGTH, ShapeParameter.DIVISIONS),
    BOX(n -> new BoxShape(n[0], (int) n[1]), ShapeParameter.LENGTH, ShapeParameter.DIVISIONS),
    CONE(
            n -> new ConeShape(n[0], n[1], (int) n[2], (int) n[3]),
            ShapeParameter.RADIUS,
            ShapeParameter.HEIGHT,
            ShapeParameter.SLICES,
            ShapeParameter.STACKS),
    SPHERE(
            n -> new SphereShape(n[0], (int) n[1], (int) n[2]),
            ShapeParameter.RADIUS,
            ShapeParameter.SLICES,
            ShapeParameter.STACKS),
    CYLINDER(
            n -> new CylinderShape(n[0], n[1], (int) n[2]),
            ShapeParameter.RADIUS,
            ShapeParameter.HEIGHT,
            ShapeParameter.SLICES),
    TORUS(
            n -> new TorusShape(n[0], n[1], (int) n[2], (int) n[3]),
            ShapeParameter.RADIUS,
            ShapeParameter.TUBE,
            ShapeParameter.SLICES,
            ShapeParameter.STACKS);

    private final Function<double[], Shape> of;
    private final List<ShapeParameter> parameters;

    ShapeKind(Function<double[], Shape> of, ShapeParameter... parameters) {
        this.of = of;
        this.parameters = List.of(parameters);
    }

    /** Returns the kind with a lower-case name; empty for an unknown name. */
    public static Optional<ShapeKind> named(String word) {
        return Stream.of(values()).filter(kind -> kind.word().equals(word)).findFirst();
    }

    /** Returns the lower-case name. */
    public String word() {
        return name().toLowerCase(Locale.ROOT);
    }

    /**
     * Creates a shape from the texts of its parameters.
     *
     * @throws IllegalArgumentException with a message for users that says what is expected
     */
    public Shape shape(List<String> numbers) {
        if (numbers.size() != parameters.size()) {
            var names = new StringJoiner(" ");
            parameters.forEach(parameter -> names.add(parameter.name()));
            throw new IllegalArgumentException(
                    word() + " takes " + parameters.size() + " numbers (" + names + "), not " + numbers.size());
        }
        double[] values = new double[numbers.size()];
        for (int i = 0; i < values.length; i++) {
            values[i] = parameters.get(i).read(numbers.get(i));
        }
        return of.apply(values);
    }
}
