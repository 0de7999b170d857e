/**
 * The package table of docs/ARCHITECTURE.md and the house style as rules, and planted violations that each rule must
 * find.
 */
package nephele.architecture;
