/** Entry point of the program. docs/architecture.md describes the packages and which of them may use which. */
package sunbeam.app;
