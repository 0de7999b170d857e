/** The oracle asked from the engine's views, and its pictures kept until something they depend on changes. */
package nephele.lab.oracle;
