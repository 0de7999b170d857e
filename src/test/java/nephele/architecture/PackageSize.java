package nephele.architecture;

import com.tngtech.archunit.core.domain.JavaClass;
import com.tngtech.archunit.lang.ArchCondition;
import com.tngtech.archunit.lang.ConditionEvents;
import com.tngtech.archunit.lang.SimpleConditionEvent;
import java.util.Collection;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.function.Function;

/** Rules that count the top-level classes of packages and names. */
final class PackageSize {
    private static final int MOST_CLASSES = 60;

    private PackageSize() {}

    static ArchCondition<JavaClass> atMost35Classes() {
        return grouped("be one of at most 60 in its package", MOST_CLASSES, JavaClass::getPackageName);
    }

    static ArchCondition<JavaClass> aNameOfItsOwn() {
        return grouped("have a simple name that no other class has", 1, JavaClass::getSimpleName);
    }

    private static ArchCondition<JavaClass> grouped(String description, int most, Function<JavaClass, String> key) {
        return new ArchCondition<>(description) {
            private final TreeMap<String, Set<String>> groups = new TreeMap<>();

            @Override
            public void init(Collection<JavaClass> all) {
                groups.clear();
                for (JavaClass type : all) {
                    groups.computeIfAbsent(key.apply(type), name -> new TreeSet<>())
                            .add(type.getName());
                }
            }

            @Override
            public void check(JavaClass type, ConditionEvents events) {
                Set<String> group = groups.get(key.apply(type));
                String message = group.size() + " classes, at most " + most + ": " + group;
                events.add(new SimpleConditionEvent(type, group.size() <= most, message));
            }
        };
    }
}
